#pragma once

#include <stdexcept>

namespace pfv {

/// The question cannot be asked: bad file, value or option. One line that quotes the value and says what is allowed.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The question is sound but this method could not answer it. One line that says why.
struct SolveError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

} // namespace pfv
