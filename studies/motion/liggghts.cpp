#include "studies/motion/liggghts.hpp"

#include "meshing/child_process.hpp"
#include "pfv/problem/error.hpp"
#include "pfv/problem/text.hpp"
#include "reference/on_path.hpp"
#include "reference/temporary_folder.hpp"
#include "studies/runner/files.hpp"

#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <sstream>

namespace studies {
namespace {

constexpr double margin = 0.01; // of the box, around the walls: a grain that overlaps one is still inside
constexpr double skin = 0.1;    // of the mean radius, of neighbour lists

std::string data_file(const pfv::Packing& packing, double density) {
  const pfv::Vec3 lower = packing.box.lower - margin * packing.box.size(),
                  upper = packing.box.upper + margin * packing.box.size();
  std::string text = fmt::format("packing\n\n{} atoms\n1 atom types\n\n", packing.spheres.size());
  for (int k = 0; k < 3; ++k)
    text += fmt::format("{0:.17g} {1:.17g} {2}lo {2}hi\n", lower[k], upper[k], "xyz"[k]);
  text += "\nAtoms\n\n";
  for (std::size_t i = 0; i < packing.spheres.size(); ++i) {
    const auto& [centre, radius] = packing.spheres[i];
    text += fmt::format("{} 1 {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}\n", i + 1, 2 * radius, density, centre.x(),
                        centre.y(), centre.z());
  }
  return text;
}

/// How the law is named, and its parameters. Walls are of the grains' material.
struct Model {
  std::string style, settings, properties;
};

Model model(const pfv::ConstantSprings& law) {
  std::string text = fmt::format("fix kn all property/global kn peratomtypepair 1 {:.17g}\n"
                                 "fix kt all property/global kt peratomtypepair 1 {:.17g}\n",
                                 law.normal, law.tangential);
  for (const char* name : {"gamman", "gammat", "gamman_abs", "gammat_abs"})
    text += fmt::format("fix {0} all property/global {0} peratomtypepair 1 0\n", name);
  return {"model hooke/stiffness tangential history", "", text};
}

/// Restitution e whose damping, sqrt(5/6) |ln e| / sqrt(pi^2 + ln^2 e) of the critical one, is the law's.
double restitution(double damping) {
  const double beta = damping / std::sqrt(5.0 / 6);
  return std::exp(-std::numbers::pi * beta / std::sqrt(1 - beta * beta));
}

Model model(const pfv::HertzMindlin& law) {
  const double e = restitution(law.friction.damping);
  return {"model hertz tangential history", " tangential_damping off",
          fmt::format("fix y all property/global youngsModulus peratomtype {:.17g}\n"
                      "fix p all property/global poissonsRatio peratomtype {:.17g}\n"
                      "fix e all property/global coefficientRestitution peratomtypepair 1 {:.17g}\n",
                      law.young, law.poisson, e)};
}

Model model(const pfv::LinearSprings&) {
  throw pfv::InputError("LIGGGHTS has no springs in proportion to the grain; constant ones, or those of Hertz");
}

std::string script(const pfv::Packing& packing, const pfv::ContactLaw& law, double step) {
  const auto [style, settings, properties] = std::visit([](const auto& one) { return model(one); }, law);
  double mean_radius = 0;
  for (const pfv::Sphere& sphere : packing.spheres)
    mean_radius += sphere.radius / static_cast<double>(packing.spheres.size());
  std::string text = "atom_style granular\natom_modify map array\nnewton off\ncommunicate single "
                     "vel yes\nunits si\n"
                     "boundary f f f\nread_data packing.data\nneigh_modify delay 0\n" +
                     properties;
  text += fmt::format("neighbor {:.6g} bin\n", skin * mean_radius);
  text += fmt::format("fix mu all property/global coefficientFriction peratomtypepair 1 {}\n",
                      pfv::friction_of(law).coefficient);
  text += fmt::format("pair_style gran {}{}\npair_coeff * *\ntimestep {:.17g}\n", style, settings, step);
  for (const pfv::Face face : pfv::all_faces) {
    const int axis = pfv::index(pfv::axis_of(face));
    const pfv::Vec3& corner = pfv::is_upper(face) ? packing.box.upper : packing.box.lower;
    text += fmt::format("fix w{} all wall/gran {} primitive type 1 {}plane {:.17g}{}\n", pfv::index(face), style,
                        "xyz"[axis], corner[axis], settings);
  }
  return text + "fix move all nve/sphere\nthermo_style custom step ke\nthermo 1000000000\n"
                "thermo_modify lost error norm no\n";
}

double cpu_of(const std::filesystem::path& folder, const std::string& input) {
  write_file(folder / "in", input);
  const auto result = meshing::run_child({"liggghts", "-in", "in"}, {.working_folder = folder, .log = folder / "out"});
  if (!result.succeeded())
    throw pfv::SolveError(
        fmt::format("liggghts: {}; its last words: {}", result.how_it_ended(), meshing::last_lines(folder / "out")));
  return result.cpu_seconds;
}

/// What is printed beside the number of a step.
double energy_at(const std::filesystem::path& output, std::size_t step) {
  std::istringstream lines(pfv::read_text(output));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::size_t at = 0;
    double energy = 0;
    if (words >> at >> energy && at == step && (words >> std::ws).eof())
      return energy;
  }
  throw pfv::SolveError(fmt::format("liggghts printed no energy at step {}", step));
}

} // namespace

std::optional<std::string> missing_liggghts() {
  if (!reference::on_path("liggghts"))
    return "no program liggghts on PATH (Debian package liggghts)";
  return std::nullopt;
}

LiggghtsRun run_liggghts(const pfv::Packing& packing, const pfv::ContactLaw& law, double density, double step,
                         std::size_t warm_up, std::size_t steps) {
  const reference::TemporaryFolder folder("liggghts");
  write_file(folder.path() / "packing.data", data_file(packing, density));
  const std::string start = script(packing, law, step) + fmt::format("run {}\n", warm_up);
  LiggghtsRun run;
  const double without = cpu_of(folder.path(), start);
  run.kinetic_energy = energy_at(folder.path() / "out", warm_up);
  run.cpu_seconds =
      (cpu_of(folder.path(), start + fmt::format("run {}\n", steps)) - without) / static_cast<double>(steps);
  return run;
}

} // namespace studies
