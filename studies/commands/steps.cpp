#include "studies/commands/commands.hpp"

#include "pfv/problem/error.hpp"
#include "pfv/simulation/read_scene.hpp"
#include "studies/effect_cost/step_cost.hpp"
#include "studies/runner/files.hpp"
#include "studies/runner/run.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>
#include <sstream>

namespace studies {
namespace {

struct StepsOptions {
  std::filesystem::path scene, out, packing;
  std::size_t warm_up = 0, steps = 1;
};

int steps(const StepsOptions& options) {
  const pfv::Scene scene = pfv::read_scene(options.scene).scene;
  try {
    if (!options.out.empty())
      write_file(options.out, to_json(step_cost(scene, options.warm_up, options.steps)));
    if (!options.packing.empty()) {
      pfv::Simulation simulation(scene);
      for (std::size_t n = 0; n < options.steps; ++n)
        simulation.advance();
      std::ostringstream text;
      write_packing(packing_of(simulation.grains().grains), text);
      write_file(options.packing, text.str());
    }
    return exit_answered;
  } catch (const pfv::SolveError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return exit_solve_error;
  }
}

} // namespace

void add_steps(CLI::App& app, Invocation& invocation) {
  auto options = std::make_shared<StepsOptions>();
  // Hidden: a study of effects starts it, one process for each run.
  CLI::App* command =
      app.add_subcommand("steps", "Steps of a scene, and what one costs as JSON. Exit code: 0 done, 2 bad "
                                  "input, 3 the scene left stability")
          ->group("");
  command->add_option("--scene", options->scene, "Scene in TOML")->required();
  command->add_option("--warm-up", options->warm_up, "Steps before those that are measured");
  command->add_option("--steps", options->steps, "Steps to measure")->check(CLI::PositiveNumber);
  command->add_option("--out", options->out, "File for what a step costs");
  command->add_option("--packing", options->packing, "File for the packing after the steps");
  command->callback([options, &invocation] { invocation.exit_code = steps(*options); });
}

} // namespace studies
