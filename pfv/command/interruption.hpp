#pragma once

#include <stdexcept>
#include <string>

namespace pfv {

/// A run that was asked to stop and has put away what it had.
struct Interrupted : std::runtime_error {
  Interrupted(const std::string& what, int by) : std::runtime_error(what), signal(by) {}
  int signal;
};

/// While there is one, the first SIGINT (Ctrl-C) or SIGTERM is kept for the run to look at between steps; one that
/// comes more than a second later ends the process at once (programs that stop others may send it twice). One at a
/// time.
class Interruption {
public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  /// The signal that asked for an end; 0 for none.
  int signal() const;
};

} // namespace pfv
