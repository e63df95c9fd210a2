#include "studies/runner/study_run.hpp"

#include "reference/method.hpp"
#include "studies/runner/build_info.hpp"
#include "studies/runner/case_store.hpp"
#include "studies/runner/finding.hpp"
#include "studies/runner/now_utc.hpp"
#include "studies/runner/number_text.hpp"
#include "studies/runner/run.hpp"
#include "studies/runner/run_key.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <map>
#include <mutex>
#include <thread>

namespace studies {

namespace {

const StudyCase& case_of(const Study& study, const std::string& id) {
  return *std::ranges::find(study.cases, id, &StudyCase::id);
}

// What a row says before the run: everything but outcome and cost.
Row identity(const Study& study, const PlannedRun& planned, const StoredCase& stored, const reference::Method& method) {
  static const std::string this_machine = machine();
  const BuildInfo& build = build_info();
  std::vector<std::string> folders = method.built_from();
  if (study.samples)
    folders.push_back("pfv/pores"); // where samples are taken
  Row row;
  row.study = study.name;
  row.case_id = planned.case_id;
  row.case_digest = stored.digest;
  row.spheres = stored.problem.packing.spheres.size();
  row.method = planned.method;
  row.mesh_size = planned.mesh_size;
  row.convergence_order = method.convergence_order();
  row.method_version = method.unavailable() ? "" : method.version();
  row.answer_sources = digest_of_sources(folders);
  row.commit = build.commit;
  row.compiler = build.compiler;
  row.flags = build.flags + (planned.ranks == 1 ? "; one thread" : fmt::format("; {} ranks", planned.ranks));
  row.machine = this_machine;
  row.key = digest(RunKey{row.case_id, row.case_digest, row.method, row.mesh_size, planned.ranks, study.samples,
                          row.method_version, row.answer_sources});
  return row;
}

Row with_outcome(Row identity, const Row& outcome) {
  identity.status = outcome.status;
  identity.message = outcome.message;
  identity.permeability = outcome.permeability;
  identity.porosity = outcome.porosity;
  identity.unknowns = outcome.unknowns;
  identity.stages = outcome.stages;
  identity.process_cpu_seconds = outcome.process_cpu_seconds;
  identity.wall_seconds = outcome.wall_seconds;
  identity.peak_memory_bytes = outcome.peak_memory_bytes;
  identity.memory_bytes = outcome.memory_bytes;
  identity.repeats = outcome.repeats;
  return identity;
}

bool within(const Budget& budget, const Row& row) {
  return row.estimated_cpu_seconds <= budget.cpu_seconds && row.estimated_memory_bytes <= budget.memory_bytes;
}

// Why a run is not started, when it is not. Fills in the estimate.
std::optional<Status> reason_not_to_run(const reference::Method& method, const pfv::Case& problem, const Budget& budget,
                                        int ranks, Row& row) {
  if (const auto reason = method.unavailable()) {
    row.message = *reason;
    return Status::unavailable;
  }
  if (const auto reason = method.not_covered(problem)) {
    row.message = *reason;
    return Status::not_covered;
  }
  const reference::Estimate estimate = method.estimate(problem, {row.mesh_size, ranks});
  row.estimated_cpu_seconds = estimate.cpu_seconds;
  row.estimated_memory_bytes = estimate.memory_bytes;
  if (within(budget, row))
    return std::nullopt;
  row.unknowns = static_cast<std::size_t>(estimate.unknowns);
  row.message = fmt::format("expected {} unknowns, {} CPU s, {}", count(estimate.unknowns),
                            seconds(estimate.cpu_seconds), bytes(estimate.memory_bytes));
  return Status::over_budget;
}

const Row* newest_with_key(const std::vector<Row>& rows, const std::string& key) {
  const auto found = std::find_if(rows.rbegin(), rows.rend(), [&](const Row& row) { return row.key == key; });
  return found == rows.rend() ? nullptr : &*found;
}

bool stands(const Row& row, bool retry_failed) {
  return row.status == Status::answered || (row.status == Status::failed && !retry_failed);
}

// An estimate can take a while for a large packing: the stored one serves as long as it is above the budget.
bool still_over(const Row& row, const Budget& budget) {
  return row.status == Status::over_budget && !within(budget, row);
}

struct Task {
  std::size_t place; // in the plan
  PlannedRun planned;
  Row identity;
  RunOrder order;
};

// Calls work(task) for each task, `jobs` at a time, and throws what the first failing one threw once all have stopped.
void in_parallel(const std::vector<Task>& tasks, int jobs, const std::function<void(const Task&)>& work) {
  std::mutex mutex;
  std::size_t next = 0;
  std::exception_ptr error;
  const auto worker = [&] {
    while (true) {
      std::unique_lock lock(mutex);
      if (next == tasks.size() || error)
        return;
      const Task& task = tasks[next++];
      lock.unlock();
      try {
        work(task);
      } catch (...) {
        lock.lock();
        error = std::current_exception();
      }
    }
  };
  {
    std::vector<std::jthread> others;
    for (int i = 1; i < jobs; ++i)
      others.emplace_back(worker);
    worker();
  }
  if (error)
    std::rethrow_exception(error);
}

} // namespace

std::vector<Row> run_study(const Study& study, const Scope& scope, const RunSettings& settings,
                           const Onlooker& onlooker) {
  const std::vector<PlannedRun> runs = plan(study, scope);
  RowStore store(settings.work.root, settings.fresh);
  if (!store.repaired().empty())
    onlooker.noticed(store.repaired());
  std::filesystem::remove_all(settings.work.scratch()); // of a study that was killed
  if (settings.fresh)
    for (const auto& folder : {settings.work.answers(), settings.work.logs(), settings.work.cases()})
      std::filesystem::remove_all(folder);

  std::map<std::string, StoredCase> cases;
  std::vector<Row> rows(runs.size());
  std::vector<Task> tasks;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const PlannedRun& planned = runs[i];
    if (!cases.contains(planned.case_id)) {
      onlooker.preparing(planned.case_id);
      const StudyCase& one = case_of(study, planned.case_id);
      const auto stored =
          cases.emplace(one.id, store_case(one, settings.work.cases(), digest_of_sources({"pfv/problem"})));
      for (const std::string& note : stored.first->second.problem.notes)
        onlooker.noticed(fmt::format("{}: {}", one.id, note));
    }
    const StoredCase& stored = cases.at(planned.case_id);
    const Budget& budget = case_of(study, planned.case_id).budget;
    const reference::Method& method = reference::find_method(planned.method);
    Row row = identity(study, planned, stored, method);
    const Row* before = newest_with_key(store.rows(), row.key);
    if (before && before->status == Status::answered) {
      if (const auto damage = damage_of(answer_file(settings.work.answers(), row.key))) {
        Row lost = *before;
        lost.status = Status::failed;
        lost.message = *damage;
        store.append(lost);
        before = &store.rows().back();
      }
    }
    if (before && (stands(*before, settings.retry_failed) || still_over(*before, budget))) {
      rows[i] = *before;
      continue;
    }
    if (const auto reason = reason_not_to_run(method, stored.problem, budget, planned.ranks, row)) {
      row.status = *reason;
      row.started = now_utc();
      if (!before || before->status != row.status || before->message != row.message)
        store.append(row);
      rows[i] = row;
      continue;
    }
    tasks.push_back(
        {i,
         planned,
         row,
         {settings.study_executable, stored.file, planned.method, planned.mesh_size, planned.ranks, study.samples,
          budget.wall_seconds, 2 * budget.memory_bytes, answer_file(settings.work.answers(), row.key),
          settings.work.logs() / (row.key + ".log"), settings.work.scratch() / row.key}});
  }
  onlooker.planned(runs.size() - tasks.size(), runs.size());

  std::mutex mutex;
  in_parallel(tasks, settings.jobs, [&](const Task& task) {
    Row row = task.identity;
    row.started = now_utc();
    {
      const std::lock_guard lock(mutex);
      onlooker.started(task.planned, row.estimated_cpu_seconds);
    }
    row = with_outcome(std::move(row), run(task.order));
    const std::lock_guard lock(mutex);
    store.append(row);
    rows[task.place] = row;
    onlooker.finished(task.planned, row);
  });
  return rows;
}

std::vector<Row> rows_of_plan(const std::vector<PlannedRun>& runs, const std::vector<Row>& stored) {
  std::map<std::string, std::string> newest_digest; // of each case: rows of an older question are not its answers
  for (const Row& row : stored)
    newest_digest[row.case_id] = row.case_digest;
  std::vector<Row> rows;
  for (const PlannedRun& run : runs) {
    const auto found = std::find_if(stored.rbegin(), stored.rend(), [&](const Row& row) {
      return row.case_id == run.case_id && row.method == run.method && row.mesh_size == run.mesh_size &&
             row.case_digest == newest_digest[row.case_id];
    });
    if (found != stored.rend())
      rows.push_back(*found);
  }
  return rows;
}

} // namespace studies
