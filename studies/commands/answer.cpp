#include "studies/commands/commands.hpp"

#include "pfv/problem/error.hpp"
#include "reference/memory_meter.hpp"
#include "reference/method.hpp"
#include "studies/runner/files.hpp"
#include "studies/runner/finding.hpp"
#include "studies/runner/run.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <new>

namespace studies {

namespace {

struct AnswerOptions {
  std::filesystem::path case_file;
  std::string method;
  double mesh_size = 1;
  int ranks = 1;
  bool samples = false;
  std::filesystem::path out;
};

bool has_free_level(const pfv::Case& problem) {
  const auto sets_it = [](const pfv::FaceCondition& face) {
    return std::holds_alternative<pfv::Pressure>(face) || std::holds_alternative<pfv::PressureProfile>(face);
  };
  return problem.pressure_points.empty() && std::ranges::none_of(problem.faces, sets_it);
}

int answer(const AnswerOptions& options) {
  const reference::Method& method = reference::find_method(options.method);
  const pfv::Case problem = pfv::read_case(options.case_file);
  try {
    reference::Request request{options.mesh_size, options.ranks};
    std::size_t pores = 0;
    if (options.samples) {
      auto [probes, lines] = reference::pore_probes(problem);
      request.probes = std::move(probes);
      pores = lines;
    }
    pfv::Clock clock;
    const reference::MemoryMeter memory;
    reference::Answer answer = method.solve(problem, request, clock);
    answer.counts.try_emplace(reference::memory_count, static_cast<double>(memory.bytes()));
    if (options.samples) {
      answer.counts[reference::sampled_pores_count] = static_cast<double>(pores);
      if (const auto setup = permeability_setup(problem); setup && setup->pressure_drop)
        answer.counts[reference::pressure_drop_count] = std::abs(*setup->pressure_drop);
      if (has_free_level(problem))
        answer.counts[free_level_count] = 1;
    }
    write_file(options.out, reference::to_json(answer));
    return exit_answered;
  } catch (const pfv::SolveError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return exit_solve_error;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "{} ran out of memory\n", method.name());
    return exit_solve_error;
  }
}

} // namespace

void add_answer(CLI::App& app, Invocation& invocation) {
  auto options = std::make_shared<AnswerOptions>();
  // Hidden: `run` and `compare` start it, one process for each run.
  CLI::App* command = app.add_subcommand("answer", "One question to one method, its answer as JSON. Exit code: 0 "
                                                   "answered, 2 bad input, 3 the method could not answer")
                          ->group("");
  command->add_option("--case", options->case_file, "Case in TOML")->required();
  command->add_option("--method", options->method, "Name of the method")->required();
  command->add_option("--mesh-size", options->mesh_size, "Scales every element length")->check(CLI::PositiveNumber);
  command->add_option("--ranks", options->ranks, "Processes that share the work")->check(CLI::Range(1, 1024));
  command->add_flag("--samples", options->samples, "Also pressures and fluxes at the pores and throats of PFV");
  command->add_option("--out", options->out, "File for the answer")->required();
  command->callback([options, &invocation] { invocation.exit_code = answer(*options); });
}

} // namespace studies
