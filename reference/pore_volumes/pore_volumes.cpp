#include "reference/pore_volumes/pore_volumes.hpp"

#include "pfv/flow/steady_flow.hpp"
#include "pfv/problem/error.hpp"
#include "pfv/problem/validate.hpp"
#include "reference/cut_spheres.hpp"
#include "reference/memory_meter.hpp"
#include "reference/pore_volumes/repeated_step.hpp"
#include "reference/pore_volumes/sample.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace reference {
namespace {

class PoreVolumes final : public Method {
public:
  PoreVolumes(std::string name, const std::string& particular = "", pfv::FlowOptions options = {})
      : name_(std::move(name)), description_("pore-scale finite volumes (PFV)" + particular),
        options_(std::move(options)) {
    options_.keep_shapes = false;
  }

  std::string name() const override { return name_; }
  std::string description() const override { return description_; }

  std::vector<std::string> built_from() const override { return {"pfv", "reference/pore_volumes"}; }

  std::optional<std::string> not_covered(const pfv::Case& problem) const override {
    try {
      pfv::validate_level(problem.faces, problem.pressure_points);
    } catch (const pfv::InputError& error) {
      return error.what();
    }
    return std::nullopt;
  }

  /// About 5.6 pores per sphere. CPU from runs of 2e2 ... 2e4 spheres: 40 us per sphere up to the system, then a solve
  /// by multigrid in 10 us per sphere, or one that grows like N^1.6 (Gauss-Seidel); memory 4 kB per sphere above the
  /// program's own 20 MB.
  Estimate estimate(const pfv::Case& problem, const Request&) const override {
    const auto spheres = static_cast<double>(problem.packing.spheres.size());
    const bool sor = std::holds_alternative<pfv::GaussSeidel>(options_.solver);
    const double solve = sor ? 5e-6 * std::pow(spheres, 1.6) : 1e-5 * spheres;
    return {5.6 * spheres, 4e-5 * spheres + solve, 2e7 + 4e3 * spheres};
  }

  Answer solve(const pfv::Case& problem, const Request& request, pfv::Clock& clock) const override {
    const MemoryMeter memory;
    pfv::FollowedFlow followed(problem, options_, clock);
    const pfv::SteadyFlow& flow = followed.flow();
    Answer answer;
    answer.method = name_;
    answer.unknowns = flow.system.unknowns();
    answer.permeability = flow.permeability;
    answer.face_flux = flow.face_flux;
    answer.porosity = flow.network.porosity();
    answer.sphere_forces.emplace();
    for (std::size_t k = 0; k < problem.packing.spheres.size(); ++k)
      answer.sphere_forces->push_back(flow.forces.of_flow(k));
    answer.wall_forces = flow.forces.on_face;
    give_normal_parts_to_slip_walls(problem, *answer.sphere_forces, *answer.wall_forces);
    answer.sphere_viscous_forces = flow.forces.viscous;
    drop_normal_parts_at_slip_walls(problem, *answer.sphere_viscous_forces);
    answer.stages = clock.stages();
    answer.counts = {{"pores", flow.network.pores.size()},
                     {"contracted_throats", flow.system.contracted_throats},
                     {"closed_throats", flow.network.closed_throats},
                     {"rounded_throats", flow.system.rounded_throats},
                     {"isolated_pores", flow.system.isolated_pores},
                     {"clamped_pores", flow.clamped_pores},
                     {"hidden_spheres", flow.network.hidden_spheres.size()},
                     {"flat_pores", flow.network.flat_pores},
                     {"iterations", flow.solver.iterations},
                     {"flux_imbalance", flow.imbalance()}};
    answer.notes = {{"solver", flow.solver.name}, {"conductance", conductance_note()}, {"walls", walls_note()}};
    if (flow.system.held_pores > 0)
      answer.counts["held_pores"] = static_cast<double>(flow.system.held_pores);
    if (!request.probes.empty())
      sample(flow, request.probes, answer);
    // Before the repeated step, whose room the answer does not need.
    answer.counts[memory_count] = static_cast<double>(memory.bytes());
    for (const auto& [stage, cpu_seconds] : repeated_step(followed, problem.packing))
      answer.stages.push_back({repeat_prefix + stage, cpu_seconds});
    return answer;
  }

private:
  std::string conductance_note() const {
    return std::visit([](const auto& rule) { return fmt::format("{}, alpha = {}", rule.name, rule.alpha); },
                      options_.conductance);
  }

  std::string walls_note() const {
    return std::visit([](const auto& rule) { return std::string(rule.name); }, options_.walls);
  }

  std::string name_;
  std::string description_;
  pfv::FlowOptions options_;
};

} // namespace

std::unique_ptr<Method> make_pore_volumes() {
  return std::make_unique<PoreVolumes>("pore_volumes");
}

std::unique_ptr<Method> make_pore_volumes_sor() {
  return std::make_unique<PoreVolumes>("pore_volumes_sor", ", over-relaxed Gauss-Seidel as in the paper",
                                       pfv::FlowOptions{.solver = pfv::GaussSeidel{}});
}

std::unique_ptr<Method> make_pore_volumes_loose() {
  return std::make_unique<PoreVolumes>("pore_volumes_loose", ", pressures to 1e-6 in the norm of the dissipated power",
                                       pfv::FlowOptions{.solver = pfv::Multigrid{.tolerance = 1e-6}});
}

std::unique_ptr<Method> make_pore_volumes_mixed_area() {
  return std::make_unique<PoreVolumes>("pore_volumes_mixed_area", ", conductance rule mixed-area",
                                       pfv::FlowOptions{.conductance = pfv::MixedArea{}});
}

std::unique_ptr<Method> make_pore_volumes_calibrated() {
  return std::make_unique<PoreVolumes>("pore_volumes_calibrated", ", conductance rule calibrated",
                                       pfv::FlowOptions{.conductance = pfv::Calibrated{}});
}

std::unique_ptr<Method> make_pore_volumes_original_walls() {
  return std::make_unique<PoreVolumes>("pore_volumes_original_walls", ", wall factors of the original implementation",
                                       pfv::FlowOptions{.walls = pfv::OriginalWalls{}});
}

} // namespace reference
