#include "pfv/command/permeability_command.hpp"

#include "pfv/command/flow_report.hpp"
#include "pfv/flow/choice.hpp"
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
  std::vector<std::string> periodic;
  std::optional<double> viscosity, scale;
  std::optional<std::string> box;
  FlowOptionNames how;
  std::string forces_file;
  std::string vtk_folder;
  bool json = false;
};

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

QuestionOptions question(const Options& options) {
  QuestionOptions said;
  if (options.axis)
    said.axis = axis_named(*options.axis);
  if (!options.periodic.empty())
    said.periodic = axes_named(options.periodic);
  said.viscosity = options.viscosity;
  said.packing.scale = options.scale;
  if (options.box)
    said.packing.box = box_named(*options.box);
  return said;
}

void run(const Options& options) {
  FlowOptions how = read_flow_options(options.file, options.how);
  how.keep_shapes = false;
  const Case problem = read_question(options.file, question(options));
  Clock clock;
  const SteadyFlow flow = solve_steady_flow(problem, how, clock);
  if (!options.forces_file.empty())
    write_forces(options.forces_file, flow.forces);
  if (!options.vtk_folder.empty())
    write_vtk(options.vtk_folder, problem.packing, flow);
  fmt::print("{}", options.json ? json_report(problem, how, flow, clock) : text_report(problem, how, flow, clock));
}

} // namespace

void add_permeability_command(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("permeability", "Steady flow through a packing: permeability and forces");
  command->add_option("FILE", options->file, "packing (text, CSV, YADE export, LAMMPS dump, VTK) or case (TOML)")
      ->required();
  command->add_option("--axis", options->axis,
                      "flow along x, y or z; by default a packing has z, under a drop of 1 Pa");
  command->add_option("--periodic", options->periodic, "axes along which the box repeats: x,y,z or fewer")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_option("--scale", options->scale,
                      "length of one unit of the packing file, and of --box (m); 1 by default");
  command->add_option("--box", options->box, "of the packing file, x0,y0,z0,x1,y1,z1; wins over the file's own");
  command->add_option("--viscosity", options->viscosity, "of the fluid (Pa s)");
  command->add_option("--solver", options->how.solver, "auto, cholmod, gauss-seidel, amg or multigrid");
  command->add_option("--walls", options->how.walls, list_of(names_of<WallRule>()));
  command->add_option("--conductance", options->how.conductance, list_of(names_of<Conductance>()));
  command->add_option("--forces", options->forces_file, "write the force on every sphere to this CSV file (N)");
  command->add_option("--vtk", options->vtk_folder, "write pores.vtu and spheres.vtp into this folder");
  command->add_flag("--json", options->json, "print one JSON object");
  command->callback([options] { run(*options); });
}

} // namespace pfv
