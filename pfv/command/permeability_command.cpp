#include "pfv/command/permeability_command.hpp"

#include "pfv/command/flow_report.hpp"
#include "pfv/flow/steady_flow.hpp"
#include "pfv/problem/error.hpp"
#include "pfv/vtk/write_vtk.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <fmt/format.h>
#include <fstream>
#include <memory>

namespace pfv {
namespace {

struct Options {
  std::string file;
  std::optional<std::string> axis;
  std::optional<double> viscosity;
  std::string solver = "auto";
  std::string walls = "mirror";
  std::string forces_file;
  std::string vtk_folder;
  bool json = false;
};

Axis axis_named(const std::string& name) {
  for (const Axis axis : {Axis::x, Axis::y, Axis::z})
    if (name == axis_names[index(axis)])
      return axis;
  throw InputError(fmt::format("--axis \"{}\" is not one of x, y, z", name));
}

WallRule walls_named(const std::string& name) {
  if (name == "mirror")
    return MirrorWalls{};
  if (name == "original")
    return OriginalWalls{};
  throw InputError(fmt::format("--walls \"{}\" is not one of mirror, original", name));
}

/// A case file as it stands, or a bare packing with flow along z; options given on the command line win.
Case read_question(const Options& options) {
  const std::filesystem::path file = options.file;
  Case problem;
  if (file.extension() == ".toml") {
    problem = read_case(file);
  } else {
    problem.name = file.stem().string();
    problem.packing = read_packing(file);
    problem.faces = flow_along(Axis::z);
  }
  if (options.axis)
    problem.faces = flow_along(axis_named(*options.axis));
  if (options.viscosity)
    problem.fluid.viscosity = *options.viscosity;
  validate(problem);
  return problem;
}

void write_forces(const std::string& file, const FluidForces& forces) {
  std::ofstream out(file);
  if (!out)
    throw InputError(fmt::format("--forces \"{}\" cannot be written", file));
  const bool buoyant = forces.buoyancy.has_value();
  out << "sphere,pressure_x,pressure_y,pressure_z,viscous_x,viscous_y,viscous_z"
      << (buoyant ? ",buoyancy_x,buoyancy_y,buoyancy_z\n" : "\n");
  const auto row = [](const Vec3& v) { return fmt::format(",{},{},{}", v.x(), v.y(), v.z()); };
  for (std::size_t k = 0; k < forces.pressure.size(); ++k)
    out << k << row(forces.pressure[k]) << row(forces.viscous[k]) << (buoyant ? row((*forces.buoyancy)[k]) : "")
        << '\n';
  if (!out.flush())
    throw InputError(fmt::format("--forces \"{}\" could not be written to its end", file));
}

void run(const Options& options) {
  FlowOptions how;
  how.solver = solver_named(options.solver);
  how.walls = walls_named(options.walls);
  const Case problem = read_question(options);
  Clock clock;
  const SteadyFlow flow = solve_steady_flow(problem, how, clock);
  if (!options.forces_file.empty())
    write_forces(options.forces_file, flow.forces);
  if (!options.vtk_folder.empty())
    write_vtk(options.vtk_folder, problem.packing, flow);
  fmt::print("{}", options.json ? json_report(problem, flow, clock) : text_report(problem, flow, clock));
}

} // namespace

void add_permeability_command(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("permeability", "Steady flow through a packing: permeability and forces");
  command->add_option("FILE", options->file, "packing (text or CSV) or case (TOML)")->required();
  command->add_option("--axis", options->axis, "flow along x, y or z: pressure 1 on the upper face, 0 on the lower");
  command->add_option("--viscosity", options->viscosity, "of the fluid (Pa s)");
  command->add_option("--solver", options->solver, "auto, cholmod, gauss-seidel, amg or multigrid")
      ->capture_default_str();
  command->add_option("--walls", options->walls, "mirror, or original: the factors of the original implementation")
      ->capture_default_str();
  command->add_option("--forces", options->forces_file, "write the force on every sphere to this CSV file (N)");
  command->add_option("--vtk", options->vtk_folder, "write pores.vtu and spheres.vtp into this folder");
  command->add_flag("--json", options->json, "print one JSON object");
  command->callback([options] { run(*options); });
}

} // namespace pfv
