#include "studies/runner/progress.hpp"

#include "studies/runner/cost.hpp"
#include "studies/runner/number_text.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

namespace studies {

namespace {

using WallClock = std::chrono::steady_clock;

std::string title(const PlannedRun& run) {
  return fmt::format("{} {} at mesh size {}", run.case_id, run.method, run.mesh_size);
}

std::string ending(const Row& row) {
  if (row.status != Status::answered)
    return fmt::format("{}: {}", name(row.status), row.message);
  return fmt::format("{} dofs, {} CPU s, {}", count(static_cast<double>(row.unknowns)),
                     seconds(cost(row.stages).total()), bytes(static_cast<double>(row.memory_bytes)));
}

} // namespace

std::string progress_bar(double elapsed_seconds, double expected_seconds, int width) {
  const std::string times = fmt::format(" {:.0f} s of about {:.0f} s", elapsed_seconds, std::ceil(expected_seconds));
  const int cells = std::min(30, width - 2 - static_cast<int>(times.size()));
  if (cells < 5)
    return times.substr(1);
  const double share = expected_seconds > 0 ? std::min(1.0, elapsed_seconds / expected_seconds) : 1.0;
  const auto full = static_cast<std::size_t>(share * cells);
  return fmt::format("[{}{}]{}", std::string(full, '#'), std::string(static_cast<std::size_t>(cells) - full, '.'),
                     times);
}

class Progress::State {
public:
  State(std::ostream& out, const Terminal& terminal) : out_(out), terminal_(terminal) {
    if (terminal_.live_progress)
      ticker_ = std::jthread([this](std::stop_token stop) { tick(stop); });
  }
  ~State() {
    ticker_ = {};
    const std::lock_guard lock(mutex_);
    clear();
    out_ << std::flush;
  }
  void line(const std::string& text) {
    const std::lock_guard lock(mutex_);
    clear();
    out_ << text << '\n' << std::flush;
  }
  void started(const PlannedRun& run, double expected) {
    if (!terminal_.live_progress)
      line(fmt::format("  started   {} (expected {} CPU s)", title(run), seconds(expected)));
    const std::lock_guard lock(mutex_);
    running_.push_back({run, expected, WallClock::now()});
    draw();
  }
  void finished(const PlannedRun& run, const Row& row) {
    line(fmt::format("  {:9} {}: {}", row.status == Status::answered ? "answered" : "failed", title(run), ending(row)));
    const std::lock_guard lock(mutex_);
    std::erase_if(running_, [&](const Running& one) { return one.run == run; });
  }

private:
  struct Running {
    PlannedRun run;
    double expected;
    WallClock::time_point start;
  };

  void tick(std::stop_token stop) {
    std::unique_lock lock(mutex_);
    while (!stop.stop_requested()) {
      draw();
      wake_.wait_for(lock, stop, std::chrono::milliseconds(250), [] { return false; });
    }
  }
  // The oldest run stands for all: one line, whatever the number of jobs.
  void draw() {
    if (!terminal_.live_progress || running_.empty())
      return;
    const Running& oldest = running_.front();
    const double elapsed = std::chrono::duration<double>(WallClock::now() - oldest.start).count();
    const std::string name = title(oldest.run).substr(0, static_cast<std::size_t>(std::max(10, terminal_.width - 45)));
    clear();
    out_ << "  " << name << ' '
         << progress_bar(elapsed, oldest.expected, terminal_.width - 4 - static_cast<int>(name.size())) << std::flush;
  }
  void clear() {
    if (terminal_.live_progress)
      out_ << "\r\033[K";
  }

  std::ostream& out_;
  Terminal terminal_;
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::vector<Running> running_;
  std::jthread ticker_; // last: stops before what it uses goes
};

Progress::Progress(std::ostream& out, const Terminal& terminal) : state_(std::make_shared<State>(out, terminal)) {}
Progress::~Progress() = default;

Onlooker Progress::onlooker() {
  Onlooker onlooker;
  onlooker.noticed = [state = state_](const std::string& what) { state->line("  " + what); };
  onlooker.preparing = [state = state_](const std::string& id) { state->line("  preparing " + id); };
  onlooker.planned = [state = state_](std::size_t stored, std::size_t all) {
    state->line(fmt::format("  {} runs, {} to do", all, all - stored));
  };
  onlooker.started = [state = state_](const PlannedRun& run, double expected) { state->started(run, expected); };
  onlooker.finished = [state = state_](const PlannedRun& run, const Row& row) { state->finished(run, row); };
  return onlooker;
}

} // namespace studies
