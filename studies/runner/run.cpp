#include "studies/runner/run.hpp"

#include "meshing/child_process.hpp"
#include "pfv/problem/error.hpp"
#include "pfv/problem/text.hpp"
#include "reference/answer.hpp"
#include "studies/runner/cost.hpp"
#include "studies/runner/files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <thread>

namespace studies {

namespace {

using WallClock = std::chrono::steady_clock;

double seconds_since(WallClock::time_point start) {
  return std::chrono::duration<double>(WallClock::now() - start).count();
}

// The temporary folder of one run. A process that is killed cannot tidy up after itself, and its children, killed with
// it, may still be writing for a moment.
class Scratch {
public:
  explicit Scratch(std::filesystem::path folder) : folder_(std::filesystem::absolute(folder)) { renew(); }
  ~Scratch() { clear(); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  void renew() const {
    clear();
    std::filesystem::create_directories(folder_);
  }
  std::string name() const { return folder_.string(); }

private:
  void clear() const {
    using namespace std::chrono_literals;
    std::error_code error;
    for (int tries = 0; tries < 20; ++tries) {
      std::filesystem::remove_all(folder_, error);
      if (!error && !std::filesystem::exists(folder_, error))
        return;
      std::this_thread::sleep_for(50ms);
    }
  }

  std::filesystem::path folder_;
};

struct Attempt {
  meshing::ChildResult child;
  double wall_seconds = 0;
  std::string answer_text;
  reference::Answer answer;
};

Attempt attempt(const RunOrder& order, const Scratch& scratch) {
  std::filesystem::path out = order.answer_file;
  out += ".new";
  std::filesystem::remove(out);
  meshing::ChildOptions options;
  options.log = order.log;
  options.wall_limit = order.wall_limit;
#ifndef __SANITIZE_ADDRESS__ // which maps far more than it uses
  options.memory_limit = static_cast<std::size_t>(order.memory_limit);
#endif
  options.environment.emplace("TMPDIR", scratch.name());
  scratch.renew();
  for (const char* threads : {"OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "DEAL_II_NUM_THREADS"})
    options.environment.emplace(threads, "1");
  std::vector<std::string> command{order.study_executable.string(),
                                   "answer",
                                   "--case",
                                   order.case_file.string(),
                                   "--method",
                                   order.method,
                                   "--mesh-size",
                                   fmt::format("{}", order.mesh_size),
                                   "--ranks",
                                   fmt::format("{}", order.ranks),
                                   "--out",
                                   out.string()};
  if (order.samples)
    command.push_back("--samples");
  const auto start = WallClock::now();
  Attempt result;
  result.child = meshing::run_child(command, options);
  result.wall_seconds = seconds_since(start);
  if (result.child.succeeded()) {
    result.answer_text = pfv::read_text(out);
    result.answer = reference::answer_from_json(result.answer_text);
    std::filesystem::remove(out);
  }
  return result;
}

void add_cost(const Attempt& attempt, Row& row) {
  row.process_cpu_seconds = attempt.child.cpu_seconds;
  row.wall_seconds = attempt.wall_seconds;
  row.peak_memory_bytes = attempt.child.peak_memory_bytes;
}

Row failed(const Attempt& attempt, const std::filesystem::path& log) {
  Row row;
  row.status = Status::failed;
  const std::string last = meshing::last_lines(log);
  // The method's own words say enough when it gave up by itself; else how the process ended comes first.
  const bool own_words = attempt.child.exit_code == exit_solve_error || attempt.child.exit_code == exit_input;
  row.message = own_words && !last.empty() ? last
                : last.empty()             ? attempt.child.how_it_ended()
                                           : fmt::format("{}: {}", attempt.child.how_it_ended(), last);
  row.repeats = 1;
  add_cost(attempt, row);
  return row;
}

Row answered(const Attempt& attempt, int repeats) {
  Row row;
  row.status = Status::answered;
  row.permeability = attempt.answer.permeability;
  row.porosity = attempt.answer.porosity;
  row.unknowns = attempt.answer.unknowns;
  row.stages = attempt.answer.stages;
  if (const auto memory = attempt.answer.counts.find(reference::memory_count); memory != attempt.answer.counts.end())
    row.memory_bytes = static_cast<std::size_t>(memory->second);
  row.repeats = repeats;
  add_cost(attempt, row);
  return row;
}

} // namespace

namespace {

Row run_in(const Scratch& scratch, const RunOrder& order, const Repetition& repetition) {
  std::filesystem::create_directories(order.answer_file.parent_path());
  std::filesystem::create_directories(order.log.parent_path());
  const auto start = WallClock::now();
  std::vector<Attempt> attempts;
  do {
    attempts.push_back(attempt(order, scratch));
    if (!attempts.back().child.succeeded())
      return failed(attempts.back(), order.log);
  } while (static_cast<int>(attempts.size()) < repetition.enough_repeats &&
           seconds_since(start) < repetition.enough_seconds);

  const auto median = attempts.begin() + static_cast<std::ptrdiff_t>((attempts.size() - 1) / 2);
  std::ranges::nth_element(attempts, median, {}, [](const Attempt& one) { return cost(one.answer.stages).total(); });
  write_file(order.answer_file, median->answer_text);
  return answered(*median, static_cast<int>(attempts.size()));
}

} // namespace

Row run(const RunOrder& order, const Repetition& repetition) {
  try {
    return run_in(Scratch(order.scratch), order, repetition);
  } catch (const std::exception& error) { // a process that cannot be started, an unreadable answer, a full disk
    Row row;
    row.message = error.what();
    return row;
  }
}

} // namespace studies
