#include "reference/lattice_boltzmann/pore_width.hpp"

#include "pfv/problem/generate.hpp"

#include <gtest/gtest.h>

namespace reference::lattice_boltzmann {
namespace {

pfv::Case through(const pfv::Packing& packing) {
  pfv::Case problem;
  problem.packing = packing;
  problem.faces = pfv::flow_along(pfv::Axis::z);
  return problem;
}

TEST(VoidMeasures, CountOnlyWhatIsInsideTheBox) {
  const double fraction = 0.4;
  for (const auto lattice : {pfv::Lattice::simple_cubic, pfv::Lattice::bcc, pfv::Lattice::fcc}) {
    const auto problem = through(pfv::lattice_packing(lattice, fraction, 2));
    const auto grid = voxel_grid(problem.packing, 1);
    const double radius = problem.packing.spheres[0].radius / grid.size;
    const auto measures = void_measures(problem, grid);
    EXPECT_NEAR(measures.width, radius * (1 - fraction) / (3 * fraction), 1e-9 * radius);
    EXPECT_NEAR(measures.surface, 3 * fraction * grid.count() / radius, 1e-6 * grid.count());
  }
}

TEST(VoidMeasures, WiderPoresAskForMoreViscosityAndLongerBoxesForLess) {
  const VoidMeasures narrow{1, 2, 50};
  EXPECT_GT((VoidMeasures{1, 4, 50}).quickest_viscosity(), narrow.quickest_viscosity());
  EXPECT_LT((VoidMeasures{1, 2, 80}).quickest_viscosity(), narrow.quickest_viscosity());
  EXPECT_GT((VoidMeasures{1, 2, 80}).steps_to_rest(), narrow.steps_to_rest());
}

} // namespace
} // namespace reference::lattice_boltzmann
