#include "reference/stokes_fem/ranks_cost.hpp"

#include "reference/stokes_fem/estimate_cost.hpp"

namespace reference::stokes_fem {

// Fits to runs of 9, 30 and 200 spheres on 1 and 2 ranks, 1e5 to 2e6 unknowns: the number of iterations hardly grows,
// so that seconds and memory are those of an unknown. A rank holds its libraries and, until it has its part, the whole
// mesh.
Estimate estimate_cost_on_ranks(const pfv::Case& problem, double mesh_size, int ranks) {
  constexpr double seconds_of_sphere = 0.15; // mesh
  constexpr double seconds_of_unknown = 5e-5;
  constexpr double seconds_of_rank = 1;
  constexpr double bytes_of_rank = 1.5e8;
  constexpr double bytes_of_unknown = 600;
  constexpr double bytes_of_whole_mesh = 150; // by unknown
  const double unknowns = estimate_cost(problem, mesh_size).unknowns;
  return {unknowns,
          seconds_of_sphere * static_cast<double>(problem.packing.spheres.size()) + seconds_of_unknown * unknowns +
              seconds_of_rank * ranks,
          ranks * (bytes_of_rank + bytes_of_whole_mesh * unknowns) + bytes_of_unknown * unknowns};
}

} // namespace reference::stokes_fem
