#include "reference/closed_form/closed_form.hpp"

#include "pfv/problem/error.hpp"
#include "reference/closed_form/lattice_drag.hpp"
#include "reference/closed_form/recognise.hpp"

#include <fmt/format.h>

#include <array>
#include <variant>

namespace reference {

namespace {

constexpr std::array<const char*, 3> lattice_names{"simple cubic", "bcc", "fcc"};

const char* name_of(pfv::Lattice lattice) {
  return lattice_names[static_cast<std::size_t>(lattice)];
}

std::string fractions_available(pfv::Lattice lattice) {
  std::string list;
  for (const LatticeDrag& row : lattice_drag_table())
    if (row.lattice == lattice)
      list += fmt::format("{}{}", list.empty() ? "" : ", ", row.solid_fraction);
  return list;
}

struct Known {
  RecognisedLattice lattice;
  LatticeDrag drag;
  pfv::PermeabilitySetup setup;
};

// What is known of the case, or why nothing is.
std::variant<Known, std::string> look_up(const pfv::Case& problem) {
  const auto setup = pfv::permeability_setup(problem);
  if (!setup || !setup->pressure_drop)
    return "needs flow along one axis under a given pressure drop or mean gradient and nothing across it";
  const auto lattice = recognise_lattice(problem.packing, periodic_axes(problem.faces));
  if (!lattice)
    return "the packing is not a simple cubic, bcc or fcc lattice of whole cells in a cube";
  const auto drag = lattice_drag(lattice->lattice, lattice->solid_fraction);
  if (!drag)
    return fmt::format("no tabulated drag of the {} lattice at solid fraction {:.6g}; there is {}",
                       name_of(lattice->lattice), lattice->solid_fraction, fractions_available(lattice->lattice));
  return Known{*lattice, *drag, *setup};
}

std::vector<pfv::Vec3> forces(const Known& known) {
  double spheres = 0;
  for (const double part : known.lattice.part_inside)
    spheres += part;
  const pfv::Vec3 total =
      -*known.setup.pressure_drop * known.setup.area * pfv::Vec3::Unit(pfv::index(known.setup.axis));
  std::vector<pfv::Vec3> list;
  list.reserve(known.lattice.part_inside.size());
  for (const double part : known.lattice.part_inside)
    list.push_back(total * part / spheres);
  return list;
}

class ClosedForm : public Method {
public:
  std::string name() const override { return "closed_form"; }
  std::string description() const override {
    return "tabulated Stokes drag of simple cubic, bcc and fcc lattices (Zick & Homsy 1982; fundamental solutions)";
  }
  std::vector<std::string> built_from() const override { return {"pfv/problem", "reference/closed_form"}; }

  std::optional<std::string> not_covered(const pfv::Case& problem) const override {
    const auto found = look_up(problem);
    if (const auto* reason = std::get_if<std::string>(&found))
      return *reason;
    return std::nullopt;
  }
  Estimate estimate(const pfv::Case&, const Request&) const override { return {0, 1e-3, 1e6}; }
  Answer solve(const pfv::Case& problem, const Request& request, pfv::Clock& clock) const override;
};

Answer ClosedForm::solve(const pfv::Case& problem, const Request&, pfv::Clock& clock) const {
  Answer answer;
  {
    const auto timing = clock.stage("look up");
    const auto found = look_up(problem);
    if (const auto* reason = std::get_if<std::string>(&found))
      throw pfv::SolveError("closed_form does not cover this case: " + *reason);
    const auto& known = std::get<Known>(found);
    const double diameter = 2 * problem.packing.spheres.front().radius;
    const int axis = pfv::index(known.setup.axis);
    answer.method = name();
    answer.permeability = diameter * diameter / (18 * known.lattice.solid_fraction * known.drag.coefficient);
    const double flux = *answer.permeability * known.setup.area * *known.setup.pressure_drop /
                        (problem.fluid.viscosity * known.setup.length);
    answer.face_flux[static_cast<std::size_t>(2 * axis)] = flux;
    answer.face_flux[static_cast<std::size_t>(2 * axis + 1)] = -flux;
    answer.porosity = 1 - known.lattice.solid_fraction;
    answer.sphere_forces = forces(known);
    answer.counts["relative_error"] = known.drag.relative_error;
    answer.counts[sauter_diameter_count] = diameter;
    answer.counts["drag_coefficient"] = known.drag.coefficient;
    answer.notes["lattice"] = fmt::format("{}, {} cells a side", name_of(known.lattice.lattice), known.lattice.cells);
  }
  answer.stages = clock.stages();
  return answer;
}

} // namespace

std::unique_ptr<Method> make_closed_form() {
  return std::make_unique<ClosedForm>();
}

} // namespace reference
