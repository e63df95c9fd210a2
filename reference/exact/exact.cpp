#include "reference/exact/exact.hpp"

#include "pfv/problem/error.hpp"
#include "reference/temporary_folder.hpp"

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <thread>

namespace reference {

namespace {

void misbehave(const std::string& mode) {
  if (mode == "fail")
    throw pfv::SolveError("exact was asked to fail (PFV_EXACT=fail)");
  if (mode == "throw")
    throw std::runtime_error("exact was asked to throw (PFV_EXACT=throw)");
  if (mode == "crash")
    std::abort();
  if (mode == "greedy") {
    const std::vector<char> gigabyte(std::size_t(1) << 30);
    std::ofstream("/dev/null").write(gigabyte.data(), 1); // or the compiler sees that nobody needs it
    return;
  }
  if (mode == "litter") {
    static const TemporaryFolder left_behind("exact");
    std::ofstream(left_behind.path() / "litter") << "as of a method that was killed\n";
    std::abort();
  }
  if (mode != "slow")
    throw pfv::InputError("PFV_EXACT is '" + mode + "'; it can be fail, throw, crash, greedy, litter or slow");
  std::this_thread::sleep_for(std::chrono::seconds(60));
}

std::vector<pfv::Vec3> forces_by_volume(const std::vector<pfv::Sphere>& spheres, const pfv::Vec3& total) {
  double cubes = 0;
  for (const pfv::Sphere& sphere : spheres)
    cubes += std::pow(sphere.radius, 3);
  std::vector<pfv::Vec3> forces;
  forces.reserve(spheres.size());
  for (const pfv::Sphere& sphere : spheres)
    forces.push_back(total * std::pow(sphere.radius, 3) / cubes);
  return forces;
}

class Exact : public Method {
public:
  std::string name() const override { return "exact"; }
  std::string description() const override {
    return "a fake with a known answer, only for testing the harness: k = 1 m^2 (1 + 0.05 mesh_size^2)";
  }
  std::optional<std::string> not_covered(const pfv::Case& problem) const override {
    const auto setup = pfv::permeability_setup(problem);
    if (!setup || !setup->pressure_drop)
      return "needs flow along one axis under a given pressure drop or mean gradient and nothing across it";
    return std::nullopt;
  }
  std::optional<double> convergence_order() const override { return 2; }
  Estimate estimate(const pfv::Case& problem, const Request& request) const override {
    return {static_cast<double>(unknowns(problem, request)), 1e-3, 1e6};
  }
  Answer solve(const pfv::Case& problem, const Request& request, pfv::Clock& clock) const override;

private:
  static std::size_t unknowns(const pfv::Case& problem, const Request& request) {
    return static_cast<std::size_t>(1000 * static_cast<double>(problem.packing.spheres.size()) /
                                    std::pow(request.mesh_size, 3)) +
           1;
  }
};

Answer Exact::solve(const pfv::Case& problem, const Request& request, pfv::Clock& clock) const {
  if (const auto reason = not_covered(problem))
    throw pfv::SolveError("exact does not cover this case: " + *reason);
  Answer answer;
  {
    const auto timing = clock.stage("solve");
    if (const char* mode = std::getenv("PFV_EXACT"); mode && *mode)
      misbehave(mode);
    const auto setup = *pfv::permeability_setup(problem);
    const int axis = pfv::index(setup.axis);
    answer.method = name();
    answer.mesh_size = request.mesh_size;
    answer.unknowns = unknowns(problem, request);
    answer.permeability = 1 + 0.05 * request.mesh_size * request.mesh_size;
    const double drop = *setup.pressure_drop;
    const double flux = *answer.permeability * setup.area * drop / (problem.fluid.viscosity * setup.length);
    answer.face_flux[static_cast<std::size_t>(2 * axis)] = flux;
    answer.face_flux[static_cast<std::size_t>(2 * axis + 1)] = -flux;
    answer.sphere_forces = forces_by_volume(problem.packing.spheres, -drop * setup.area * pfv::Vec3::Unit(axis));
    answer.counts["flux_imbalance"] = 0;
    answer.notes["fake"] = "yes: this is the harness testing itself";
  }
  answer.stages = clock.stages();
  return answer;
}

} // namespace

std::unique_ptr<Method> make_exact() {
  return std::make_unique<Exact>();
}

} // namespace reference
