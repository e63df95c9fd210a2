#pragma once

#include <chrono>
#include <string>

namespace pfv {

/// "[#####.....]  50 %  t = 0.25 s  12 s left" of a share between 0 and 1.
std::string progress_line(double share, double time, double seconds_left);

/// The share of a run that is done, its time and the seconds that are left, on a line of the terminal that is written
/// over a few times a second; nothing where standard error is no terminal.
class RunProgress {
public:
  /// What was done already when the run starts, as by who saved it.
  explicit RunProgress(double done);
  ~RunProgress();
  RunProgress(const RunProgress&) = delete;
  RunProgress& operator=(const RunProgress&) = delete;

  void show(double share, double time);

private:
  using Clock = std::chrono::steady_clock;

  bool shown_;
  double done_;
  Clock::time_point start_, next_;
};

} // namespace pfv
