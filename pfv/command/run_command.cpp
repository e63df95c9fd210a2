#include "pfv/command/run_command.hpp"

#include "pfv/command/run_report.hpp"
#include "pfv/flow/choice.hpp"
#include "pfv/problem/error.hpp"
#include "pfv/simulation/read_scene.hpp"

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <fmt/format.h>
#include <fstream>
#include <memory>
#include <unistd.h>

namespace pfv {
namespace {

struct Options {
  std::string file;
  std::optional<std::size_t> steps;
  std::optional<double> until;
  std::optional<std::string> scheme;
  std::string packing_file, history_file;
  std::size_t every = 100;
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

/// A line that is written over on a terminal, a few times a second; none elsewhere.
class Progress {
public:
  Progress() : shown_(isatty(STDERR_FILENO) != 0), start_(Clock::now()), last_(start_) {}
  ~Progress() {
    if (shown_)
      fmt::print(stderr, "\r{:60}\r", "");
  }
  void show(double share, double time) {
    const auto now = Clock::now();
    if (!shown_ || share <= 0 || now - last_ < std::chrono::milliseconds(200))
      return;
    last_ = now;
    const double past = std::chrono::duration<double>(now - start_).count();
    fmt::print(stderr, "\r{:3.0f} %  t = {:.4g} s  {:.0f} s left    ", 100 * share, time, past * (1 / share - 1));
  }

private:
  using Clock = std::chrono::steady_clock;
  bool shown_;
  Clock::time_point start_, last_;
};

Duration duration_of(const Options& options, Duration in_file) {
  if (!options.steps && !options.until && !in_file.steps && !in_file.until)
    throw InputError("how long the scene runs is not said: --steps, --until, or steps or until in [run]");
  return options.steps || options.until ? Duration{options.until, options.steps} : in_file;
}

void run(const Options& options) {
  SceneFile file = read_scene(options.file);
  if (options.scheme)
    file.scene.scheme = choice_named<TimeScheme>("--scheme", *options.scheme);
  const Duration duration = duration_of(options, file.duration);
  std::optional<Output> history, packing;
  if (!options.history_file.empty())
    history.emplace("--history", options.history_file).stream() << history_header();
  if (!options.packing_file.empty())
    packing.emplace("--packing", options.packing_file);

  Simulation simulation(file.scene);
  if (!options.json)
    fmt::print("{}", opening_report(file.scene, simulation));
  {
    Progress progress;
    const auto share = [&] {
      const double of_steps =
          duration.steps ? static_cast<double>(simulation.steps()) / static_cast<double>(*duration.steps) : 0;
      return std::max(of_steps, duration.until ? simulation.grains().time / *duration.until : 0);
    };
    while (share() < 1) {
      simulation.advance();
      if (history && simulation.steps() % options.every == 0)
        history->stream() << history_row(simulation);
      progress.show(share(), simulation.grains().time);
    }
  }
  if (history)
    history->finish();
  if (packing) {
    write_packing(packing_of(simulation.grains().grains), packing->stream());
    packing->finish();
  }
  fmt::print("{}", options.json ? json_report(file.scene, simulation) : closing_report(simulation));
}

} // namespace

void add_run_command(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("run", "Grains in motion, with the effects that the scene names");
  command->add_option("FILE", options->file, "scene (TOML)")->required();
  command->add_option("--steps", options->steps, "how many steps to take");
  command->add_option("--until", options->until, "time to simulate (s)");
  command->add_option("--scheme", options->scheme, list_of(names_of<TimeScheme>()));
  command->add_option("--packing", options->packing_file, "write the packing at the end to this file");
  command->add_option("--history", options->history_file, "write box, energies and pressure in time to this CSV file");
  command->add_option("--every", options->every, "steps between rows of the history")->check(CLI::PositiveNumber);
  command->add_flag("--json", options->json, "print one JSON object");
  command->callback([options] { run(*options); });
}

} // namespace pfv
