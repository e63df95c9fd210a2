#include "pfv/command/run_command.hpp"

#include "pfv/command/interruption.hpp"
#include "pfv/command/run_progress.hpp"
#include "pfv/command/run_report.hpp"
#include "pfv/flow/choice.hpp"
#include "pfv/problem/error.hpp"
#include "pfv/problem/text.hpp"
#include "pfv/simulation/read_scene.hpp"
#include "pfv/simulation/relax.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <fmt/format.h>
#include <fstream>
#include <memory>

namespace pfv {
namespace {

struct Options {
  std::string file;
  std::optional<long long> steps;
  std::optional<double> until;
  std::optional<std::string> scheme;
  std::string packing_file, history_file, save_file, restart_file;
  std::optional<double> save_every;
  long long every = 100;
  bool json = false;
};

class Output {
public:
  Output(const char* option, const std::string& file) : option_(option), file_(file), out_(file) {
    if (!out_)
      throw InputError(fmt::format("{} \"{}\" cannot be written", option, file));
  }
  std::ostream& stream() { return out_; }
  void finish() {
    if (!out_.flush())
      throw InputError(fmt::format("{} \"{}\" could not be written to its end", option_, file_));
  }

private:
  const char* option_;
  std::string file_;
  std::ofstream out_;
};

/// Saves at the end, and before whenever another `every` seconds have been simulated.
class Saves {
public:
  Saves(const Options& options, double time) : file_(options.save_file), every_(options.save_every) {
    if (!file_.empty())
      require_writable(file_);
    set_next(time);
  }
  void save(Simulation& simulation) {
    if (file_.empty())
      return;
    write_checkpoint(file_, simulation.checkpoint());
    saved_at_ = simulation.grains().time;
  }
  void save_if_due(Simulation& simulation) {
    if (!every_ || simulation.grains().time < next_)
      return;
    save(simulation);
    set_next(simulation.grains().time);
  }
  /// What can be gone on from after a failure, as the end of a message.
  std::string last() const { return saved_at_ ? fmt::format("; saved at {:.6g} s in {}", *saved_at_, file_) : ""; }

private:
  void set_next(double time) {
    if (every_)
      next_ = *every_ * (std::floor(time / *every_) + 1);
  }

  std::string file_;
  std::optional<double> every_, saved_at_; // s
  double next_ = 0;                        // s
};

void require_above_zero(const char* option, const std::optional<double>& value) {
  if (value && !(*value > 0 && std::isfinite(*value)))
    throw InputError(fmt::format("{} \"{}\" must be above 0 and finite", option, shortest(*value)));
}

Duration duration_of(const Options& options, const Duration& in_file) {
  require_above_zero("--until", options.until);
  require_above_zero("--save-every", options.save_every);
  if (options.steps && *options.steps < 1)
    throw InputError(fmt::format("--steps \"{}\" must be 1 or more", *options.steps));
  if (!options.steps && !options.until && !in_file.steps && !in_file.until)
    throw InputError("how long the scene runs is not said: --steps, --until, or steps or until in [run]");
  if (!options.steps && !options.until)
    return in_file;
  return {options.until, options.steps ? std::optional<std::size_t>(*options.steps) : std::nullopt, in_file.unbalanced};
}

/// Of the run that is done, counted from the start of its first part.
double share_done(const Duration& duration, const Simulation& simulation) {
  const double of_steps =
      duration.steps ? static_cast<double>(simulation.steps()) / static_cast<double>(*duration.steps) : 0;
  return std::max(of_steps, duration.until ? simulation.grains().time / *duration.until : 0);
}

Simulation start(const Scene& scene, const std::string& restart_file) {
  if (restart_file.empty())
    return Simulation(scene);
  const Checkpoint checkpoint = read_checkpoint(restart_file);
  try {
    require_same_grains(checkpoint, scene);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", restart_file, error.what()));
  }
  return Simulation(scene, checkpoint);
}

/// Looked at from time to time: the grains have come to rest, where the scene ends with that.
bool at_rest(const Duration& duration, const Simulation& simulation) {
  constexpr std::size_t steps_between_looks = 200;
  return duration.unbalanced && simulation.steps() % steps_between_looks == 0 &&
         in_equilibrium(simulation.grains(), {*duration.unbalanced});
}

/// To the end of the duration, or to the step after an interruption.
void advance(Simulation& simulation, const Duration& duration, const Interruption& interruption, Saves& saves,
             std::optional<Output>& history, std::size_t every) {
  RunProgress progress(share_done(duration, simulation));
  while (share_done(duration, simulation) < 1) {
    simulation.advance();
    if (history && simulation.steps() % every == 0)
      history->stream() << history_row(simulation);
    saves.save_if_due(simulation);
    progress.show(share_done(duration, simulation), simulation.grains().time);
    if (at_rest(duration, simulation) || interruption.signal() != 0)
      return;
  }
  if (duration.unbalanced)
    throw SolveError(fmt::format("the grains did not come to rest in {} steps: unbalanced force {:.2g}, wanted {:.2g} "
                                 "with every stress that the scene asks for",
                                 simulation.steps(), simulation.grains().unbalanced_force(), *duration.unbalanced));
}

void run(const Options& options) {
  SceneFile file = read_scene(options.file);
  if (options.scheme)
    file.scene.scheme = choice_named<TimeScheme>("--scheme", *options.scheme);
  const Duration duration = duration_of(options, file.duration);
  Simulation simulation = start(file.scene, options.restart_file);
  Saves saves(options, simulation.grains().time);
  std::optional<Output> history, packing;
  if (!options.history_file.empty())
    history.emplace("--history", options.history_file).stream() << history_header();
  if (!options.packing_file.empty())
    packing.emplace("--packing", options.packing_file);

  if (!options.json)
    fmt::print("{}", opening_report(file.scene, simulation));
  const Interruption interruption;
  try {
    advance(simulation, duration, interruption, saves, history, static_cast<std::size_t>(options.every));
  } catch (const SolveError& error) {
    throw SolveError(error.what() + saves.last());
  }
  if (history)
    history->finish();
  if (packing) {
    write_packing(packing_of(simulation.grains().grains), packing->stream());
    packing->finish();
  }
  fmt::print("{}", options.json ? json_report(file.scene, simulation) : closing_report(simulation));
  saves.save(simulation);
  if (interruption.signal() != 0)
    throw Interrupted(
        fmt::format("interrupted after {} steps{}", simulation.steps(),
                    options.save_file.empty() ? "; without --save there is nothing to go on from" : saves.last()),
        interruption.signal());
}

} // namespace

void add_run_command(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("run", "Grains in motion, with the effects that the scene names");
  command->add_option("FILE", options->file, "scene (TOML)")->required();
  command->add_option("--steps", options->steps, "how many steps to take, those before a restart included");
  command->add_option("--until", options->until, "time to simulate to (s)");
  command->add_option("--scheme", options->scheme, list_of(names_of<TimeScheme>()));
  command->add_option("--packing", options->packing_file, "write the packing at the end to this file");
  command->add_option("--history", options->history_file, "write box, energies and pressure in time to this CSV file");
  command->add_option("--every", options->every, "steps between rows of the history")->check(CLI::PositiveNumber);
  auto* save = command->add_option("--save", options->save_file, "write what is needed to go on from the end here");
  command->add_option("--save-every", options->save_every, "seconds simulated between saves before the end")
      ->needs(save);
  command->add_option("--restart", options->restart_file, "go on from a file that --save wrote");
  command->add_flag("--json", options->json, "print one JSON object");
  command->callback([options] { run(*options); });
}

} // namespace pfv
