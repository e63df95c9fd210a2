#pragma once

#include "meshing/child_process.hpp"

#include <chrono>
#include <sys/resource.h>
#include <sys/types.h>
#include <unistd.h>

namespace meshing {

// A child as the leader of a process group of its own.

using Wall = std::chrono::steady_clock;

/// A file descriptor that is closed with its owner.
class Descriptor {
public:
  explicit Descriptor(int value) : value_(value) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int value() const { return value_; }
  void close() {
    if (value_ >= 0)
      ::close(value_);
    value_ = -1;
  }

private:
  int value_;
};

/// Throws std::system_error of this errno.
[[noreturn]] void fail(int error, const std::string& what);

/// In the child: a group of its own that dies with the parent, of at most so much memory (bytes). Only
/// async-signal-safe calls.
void become_child(pid_t parent, rlim_t memory);

/// In the parent: waits for the leader of the group, ends what is left of it and tells how it went.
/// Throws std::system_error, whose text begins with `cannot`, when it cannot wait.
ChildResult wait_for(pid_t child, Wall::time_point start, const ChildOptions& options, const std::string& cannot);

/// Bytes: what the options allow of what this process may have.
rlim_t memory_of(const ChildOptions& options);

/// Where a child's output goes; negative when it cannot be opened.
int open_log(const ChildOptions& options);

} // namespace meshing
