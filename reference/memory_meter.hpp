#pragma once

#include <cstddef>

namespace reference {

/// What the code between construction and `bytes` needs at its largest, apart from the libraries and the input that are
/// in memory already: those would hide a small method behind the largest one of the build.
class MemoryMeter {
public:
  MemoryMeter();
  /// The larger of what this process grew by since and the largest child process it has waited for.
  std::size_t bytes() const;

private:
  std::size_t before_;
};

} // namespace reference
