#include "studies/runner/status.hpp"

#include "pfv/problem/error.hpp"

#include <fmt/format.h>

namespace studies {

std::string_view name(Status status) {
  switch (status) {
  case Status::answered:
    return "answered";
  case Status::not_covered:
    return "not covered";
  case Status::unavailable:
    return "unavailable";
  case Status::over_budget:
    return "not run: over budget";
  case Status::failed:
    return "failed";
  }
  return "";
}

Status status_from(std::string_view text) {
  std::string valid;
  for (const Status status : all_statuses) {
    if (name(status) == text)
      return status;
    valid += fmt::format("{}'{}'", valid.empty() ? "" : ", ", name(status));
  }
  throw pfv::InputError(fmt::format("unknown status '{}'; it can be one of {}", text, valid));
}

} // namespace studies
