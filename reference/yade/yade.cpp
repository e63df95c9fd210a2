#include "reference/yade/yade.hpp"

#include "pfv/problem/error.hpp"
#include "reference/yade/flow_engine.hpp"
#include "reference/yade/limits.hpp"
#include "reference/yade/program.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace reference {

namespace {

using namespace yade;

// A direct solver balances to round-off; one that has not solved is off by the whole flux.
constexpr double largest_imbalance = 1e-6;

void add_stages(const Reply& reply, pfv::Clock& clock) {
  // The first call makes factors and solution under one timer; the repeated one tells what of it is the solution.
  const double solve = std::min(reply.first.solve, reply.repeated.solve);
  clock.add("network", reply.first.network);
  clock.add("factor", reply.first.solve - solve);
  clock.add("solve", solve);
  clock.add("forces", reply.first.forces);
  clock.add(repeat_prefix + "solve", reply.repeated.solve);
  clock.add(repeat_prefix + "forces", reply.repeated.network + reply.repeated.forces);
}

// FlowEngine knows cells, not where in them there is a sphere.
std::vector<double> of_void(std::vector<double> pressures, const pfv::Packing& packing,
                            const std::vector<pfv::Vec3>& points) {
  for (std::size_t i = 0; i < points.size(); ++i)
    if (in_solid(packing, points[i]))
      pressures[i] = std::nan("");
  return pressures;
}

class Yade final : public Method {
public:
  std::string name() const override { return "yade"; }
  std::string description() const override {
    return "pore-scale finite volumes by the original implementation (FlowEngine of YADE)";
  }
  std::string version() const override { return program_version(); }
  std::vector<std::string> built_from() const override { return {"pfv/problem", "meshing", "reference/yade"}; }

  std::optional<std::string> unavailable() const override { return missing_program(); }
  std::optional<std::string> not_covered(const pfv::Case& problem) const override { return beyond_limits(problem); }
  Estimate estimate(const pfv::Case& problem, const Request&) const override { return expected_cost(problem); }

  Answer solve(const pfv::Case& problem, const Request& request, pfv::Clock& clock) const override {
    if (const auto reason = unavailable())
      throw pfv::SolveError("yade is unavailable: " + *reason);
    if (const auto reason = not_covered(problem))
      throw pfv::SolveError("yade does not cover this case: " + *reason);
    // Starting up can take a minute when nothing of it is in memory yet.
    const double wall_limit = 120 + 20 * expected_cost(problem).cpu_seconds;
    const Reply reply = run_flow_engine(problem, request.probes.points, wall_limit);
    const auto setup = *pfv::permeability_setup(problem);
    const double imbalance = std::abs(reply.flux_in / reply.flux_out - 1);
    if (!(imbalance < largest_imbalance))
      throw pfv::SolveError(fmt::format("FlowEngine's fluxes do not balance: {:.6g} m^3/s in, {:.6g} out",
                                        reply.flux_in, reply.flux_out));
    add_stages(reply, clock);

    Answer answer;
    answer.method = name();
    answer.unknowns = reply.cells;
    answer.face_flux[static_cast<std::size_t>(pfv::index(pfv::lower_face(setup.axis)))] = reply.flux_out;
    answer.face_flux[static_cast<std::size_t>(pfv::index(pfv::upper_face(setup.axis)))] = -reply.flux_in;
    const double flux = (reply.flux_in + reply.flux_out) / 2;
    answer.permeability = problem.fluid.viscosity * flux * setup.length / (setup.area * *setup.pressure_drop);
    answer.sphere_forces = reply.forces;
    if (!request.probes.points.empty())
      answer.point_pressures = of_void(reply.pressures, problem.packing, request.probes.points);
    answer.stages = clock.stages();
    answer.counts = {{"cells", static_cast<double>(reply.cells)},
                     {"flux_imbalance", imbalance},
                     {memory_count, reply.peak_memory - reply.memory_before},
                     {"process_memory_bytes", reply.peak_memory}};
    answer.notes = {
        {"version", "YADE " + reply.version},
        {"solver", "CHOLMOD"},
        {"units", "length of the box, pressure drop and viscosity: its clamp depends on the unit of length"},
        {"walls", "original: conductances times 2^(-1/2) for each wall touched"},
        {"forces", "wrong on four of the eight spheres next to the corners of the box"}};
    return answer;
  }
};

} // namespace

std::unique_ptr<Method> make_yade() {
  return std::make_unique<Yade>();
}

} // namespace reference
