#pragma once

#include <string_view>

namespace studies {

/// What a comparison with the reference says.
enum class Outcome {
  agrees,      // every difference is within the tolerance or within the two error bars
  differs,     // at least one difference is larger than both
  not_covered, // the method or the reference does not answer this case
  unavailable, // the method cannot run here, or the reference has no answer to compare with
  failed       // the method tried and has no answer
};

constexpr std::string_view name(Outcome outcome) {
  switch (outcome) {
  case Outcome::agrees:
    return "agrees";
  case Outcome::differs:
    return "differs";
  case Outcome::not_covered:
    return "not covered";
  case Outcome::unavailable:
    return "unavailable";
  case Outcome::failed:
    return "failed";
  }
  return "";
}

} // namespace studies
