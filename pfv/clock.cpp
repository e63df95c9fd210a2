#include "pfv/clock.hpp"

#include <algorithm>
#include <ctime>
#include <sys/resource.h>

namespace pfv {

Clock::Timing::Timing(Clock& clock, std::size_t stage)
    : clock_(clock), stage_(stage), around_(clock.innermost_), start_(process_cpu_seconds()) {
  clock_.innermost_ = this;
}

Clock::Timing::~Timing() {
  const double spent = process_cpu_seconds() - start_;
  clock_.stages_[stage_].cpu_seconds += spent - within_;
  if (around_ != nullptr)
    around_->within_ += spent;
  clock_.innermost_ = around_;
}

Clock::Timing Clock::stage(const std::string& name) {
  return Timing(*this, find_or_append(name));
}

void Clock::add(const std::string& name, double cpu_seconds) {
  stages_[find_or_append(name)].cpu_seconds += cpu_seconds;
}

std::size_t Clock::find_or_append(const std::string& name) {
  const auto found = std::ranges::find(stages_, name, &Stage::name);
  if (found != stages_.end())
    return static_cast<std::size_t>(found - stages_.begin());
  stages_.push_back({name, 0});
  return stages_.size() - 1;
}

double process_cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::size_t peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

} // namespace pfv
