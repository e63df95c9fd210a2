#include "studies/runner/now_utc.hpp"

#include <fmt/chrono.h>

#include <chrono>

namespace studies {

std::string now_utc() {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::chrono::system_clock::now()));
}

} // namespace studies
