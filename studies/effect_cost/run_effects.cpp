#include "studies/effect_cost/run_effects.hpp"

#include "meshing/child_process.hpp"
#include "pfv/problem/error.hpp"
#include "pfv/problem/text.hpp"
#include "pfv/simulation/read_scene.hpp"
#include "studies/effect_cost/step_cost.hpp"
#include "studies/runner/build_info.hpp"
#include "studies/runner/files.hpp"
#include "studies/runner/now_utc.hpp"
#include "studies/runner/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace studies {
namespace {

std::string sources() {
  return digest_of_sources(
      {"pfv/problem", "pfv/pores", "pfv/solvers", "pfv/flow", "pfv/grains", "pfv/simulation", "studies/effect_cost"});
}

/// Of a preparation and the sources it runs with: another one leaves another packing.
std::string digest_of_packing(const EffectStudy& study, const std::string& from_sources) {
  return text_digest(fmt::format("{}\n{}\n{}", study.preparation, study.preparation_steps, from_sources));
}

std::filesystem::path packing_file(const EffectStudy& study, const WorkFolder& work) {
  return std::filesystem::absolute(work.cases() / ("packing-" + digest_of_packing(study, sources()) + ".txt"));
}

meshing::ChildResult steps_of(const RunSettings& settings, const std::filesystem::path& scene, std::size_t warm_up,
                              std::size_t steps, const std::string& option, const std::filesystem::path& out,
                              const std::filesystem::path& log) {
  meshing::ChildOptions options;
  options.log = log;
  for (const char* threads : {"OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"})
    options.environment.emplace(threads, "1");
  return meshing::run_child({settings.study_executable.string(), "steps", "--scene", scene.string(), "--warm-up",
                             fmt::format("{}", warm_up), "--steps", fmt::format("{}", steps), option, out.string()},
                            options);
}

void prepare(const EffectStudy& study, const RunSettings& settings, const Tell& tell) {
  const auto packing = packing_file(study, settings.work);
  if (std::filesystem::exists(packing))
    return;
  tell(fmt::format("preparing the packing, {} steps", study.preparation_steps));
  const auto scene = settings.work.cases() / "preparation.toml", log = settings.work.logs() / "preparation.log";
  write_file(scene, study.preparation);
  pfv::read_scene(scene);
  auto unfinished = packing;
  unfinished += ".new";
  const auto child = steps_of(settings, scene, 0, study.preparation_steps, "--packing", unfinished, log);
  if (!child.succeeded())
    throw pfv::SolveError(
        fmt::format("the preparation failed, {}: {}", child.how_it_ended(), meshing::last_lines(log)));
  std::filesystem::rename(unfinished, packing);
}

/// What a row says before the run; `from_sources` are those of another build when the row is looked for, not made.
Row identity(const EffectStudy& study, const Effect& effect, int repeat, const std::string& from_sources) {
  static const std::string this_machine = machine();
  Row row;
  row.study = study.name;
  row.case_id = effect.id;
  row.case_digest = text_digest(effect.scene + digest_of_packing(study, from_sources));
  row.method = "pfv run";
  row.repeats = repeat;
  row.answer_sources = from_sources;
  row.commit = build_info().commit;
  row.compiler = build_info().compiler;
  row.flags = build_info().flags + "; one thread";
  row.machine = this_machine;
  row.key = text_digest(fmt::format("{}\n{}\n{}\n{}\n{}\n{}", row.case_id, row.case_digest, row.answer_sources,
                                    effect.steps, study.warm_up, repeat));
  return row;
}

void run_one(const EffectStudy& study, const Effect& effect, const RunSettings& settings, Row& row) {
  const auto out = settings.work.scratch() / (row.key + ".json"), log = settings.work.logs() / (row.key + ".log");
  const auto scene = settings.work.cases() / (effect.id + ".toml");
  row.started = now_utc();
  const auto child = steps_of(settings, scene, study.warm_up, effect.steps, "--out", out, log);
  row.process_cpu_seconds = child.cpu_seconds;
  row.wall_seconds = child.wall_seconds;
  row.peak_memory_bytes = child.peak_memory_bytes;
  if (!child.succeeded()) {
    row.status = Status::failed;
    row.message = fmt::format("{}: {}", child.how_it_ended(), meshing::last_lines(log));
    return;
  }
  const StepCost cost = step_cost_from_json(pfv::read_text(out));
  std::filesystem::remove(out);
  row.status = Status::answered;
  row.spheres = cost.spheres;
  row.unknowns = cost.pores;
  row.memory_bytes = cost.memory_bytes;
  row.stages = cost.of_step;
}

/// The newest stored row of a run; nothing when there is none.
const Row* stored_row(const std::vector<Row>& rows, const std::string& key) {
  const auto found = std::find_if(rows.rbegin(), rows.rend(), [&](const Row& row) { return row.key == key; });
  return found == rows.rend() ? nullptr : &*found;
}

std::vector<Row> rows_of_plan(const EffectStudy& study, const std::vector<Row>& stored,
                              const std::string& from_sources) {
  std::vector<Row> rows;
  for (const Effect& effect : study.effects)
    for (int repeat = 1; repeat <= study.repeats; ++repeat)
      if (const Row* row = stored_row(stored, identity(study, effect, repeat, from_sources).key))
        rows.push_back(*row);
  return rows;
}

} // namespace

std::vector<Row> run_effects(const EffectStudy& study, const RunSettings& settings, const Tell& tell) {
  const WorkFolder& work = settings.work;
  RowStore store(work.root, settings.fresh);
  if (!store.repaired().empty())
    tell(store.repaired());
  if (settings.fresh)
    for (const auto& folder : {work.logs(), work.cases()})
      std::filesystem::remove_all(folder);
  for (const auto& folder : {work.cases(), work.logs(), work.scratch()})
    std::filesystem::create_directories(folder);
  prepare(study, settings, tell);
  for (const Effect& effect : study.effects) {
    const auto file = work.cases() / (effect.id + ".toml");
    write_file(file, fmt::format("packing.file = \"{}\"\n{}", packing_file(study, work).string(), effect.scene));
    pfv::read_scene(file);
  }

  const auto is_done = [&](const Row& row) {
    const Row* before = stored_row(store.rows(), row.key);
    return before && (before->status == Status::answered || !settings.retry_failed);
  };
  std::size_t done = 0;
  for (const Row& row : rows_of_plan(study, store.rows(), sources()))
    done += is_done(row);
  const std::size_t runs = study.effects.size() * static_cast<std::size_t>(study.repeats);
  tell(fmt::format("{} runs, {} to do", runs, runs - done));
  for (int repeat = 1; repeat <= study.repeats; ++repeat)
    for (const Effect& effect : study.effects) {
      Row row = identity(study, effect, repeat, sources());
      if (is_done(row))
        continue;
      run_one(study, effect, settings, row);
      store.append(row);
      tell(fmt::format("{}, run {} of {}: {}", effect.id, repeat, study.repeats,
                       row.status == Status::answered
                           ? fmt::format("{} CPU s a step", seconds(row.stages.front().cpu_seconds))
                           : row.message));
    }
  std::filesystem::remove_all(work.scratch());
  return rows_of_plan(study, store.rows(), sources());
}

std::vector<Row> stored_effects(const EffectStudy& study, const WorkFolder& work) {
  const std::vector<Row> stored = read_rows(work.rows());
  for (auto row = stored.rbegin(); row != stored.rend(); ++row)
    if (std::vector<Row> rows = rows_of_plan(study, stored, row->answer_sources); !rows.empty())
      return rows;
  return {};
}

} // namespace studies
