#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace pfv {

struct Stage {
  std::string name;
  double cpu_seconds = 0;

  bool operator==(const Stage&) const = default;
};

/// CPU seconds by named stage, in order of first appearance; a stage that runs twice accumulates. What a stage within a
/// stage takes is its own alone.
///   Clock clock;
///   { auto timing = clock.stage("triangulate"); ... }
class Clock {
public:
  class Timing {
  public:
    Timing(Clock& clock, std::size_t stage);
    ~Timing();
    Timing(const Timing&) = delete;
    Timing& operator=(const Timing&) = delete;

  private:
    Clock& clock_;
    std::size_t stage_;
    Timing* around_;
    double start_;
    double within_ = 0; // spent in stages within this one
  };

  [[nodiscard]] Timing stage(const std::string& name);
  void add(const std::string& name, double cpu_seconds);
  const std::vector<Stage>& stages() const { return stages_; }

private:
  std::size_t find_or_append(const std::string& name);
  std::vector<Stage> stages_;
  Timing* innermost_ = nullptr;
};

/// CPU seconds of this process so far, user and system, all threads.
double process_cpu_seconds();

/// Largest resident memory of this process so far, in bytes.
std::size_t peak_memory_bytes();

} // namespace pfv
