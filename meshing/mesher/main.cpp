#include "meshing/mesher/generate_mesh.hpp"
#include "pfv/problem/case.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <fmt/format.h>
#include <fstream>
#include <gmsh.h>
#include <stdexcept>

namespace {

std::string version() {
  gmsh::initialize();
  std::string number;
  gmsh::option::getString("General.Version", number);
  gmsh::finalize();
  return fmt::format("gmsh {}, mesher {}", number, mesher::version);
}

struct Options {
  std::string problem;
  std::string mesh;
  std::string quality;
  double mesh_size = 1;
  double bridge_radius = 0.15;
};

void run(const Options& options) {
  const pfv::Case problem = pfv::read_case(options.problem);
  gmsh::initialize();
  const auto quality = mesher::generate_mesh(problem.packing, pfv::periodic_axes(problem.faces), options.mesh_size,
                                             options.bridge_radius, options.mesh);
  gmsh::finalize();
  std::ofstream out(options.quality);
  out << meshing::to_json(quality) << '\n';
  if (!out.flush())
    throw std::runtime_error(fmt::format("cannot write {}", options.quality));
}

} // namespace

#ifdef __SANITIZE_ADDRESS__
/// gmsh and OpenCASCADE leak; what leaks here is still found.
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libgmsh\nleak:libTK\n";
}
#endif

int main(int argc, char** argv) {
  Options options;
  CLI::App app("Meshes the void between the spheres of a case with gmsh");
  app.set_version_flag("--version", version);
  app.add_option("case", options.problem, "TOML file with a [packing]")->required()->check(CLI::ExistingFile);
  app.add_option("mesh", options.mesh, "ASCII MSH 2.2 file to write")->required();
  app.add_option("quality", options.quality, "JSON file to write")->required();
  app.add_option("--mesh-size", options.mesh_size, "scales every element length")->check(CLI::PositiveNumber);
  app.add_option("--bridge-radius", options.bridge_radius, "of contacts, in units of the smaller sphere radius")
      ->check(CLI::Range(0.0, 0.5));
  CLI11_PARSE(app, argc, argv);
  try {
    run(options);
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
  }
  return 1;
}
