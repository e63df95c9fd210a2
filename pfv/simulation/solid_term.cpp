#include "pfv/simulation/solid_term.hpp"

#include <cmath>
#include <numeric>

namespace pfv {

GramTerm solid_term(const SolidFlux& flux, const FlowSystem& system, std::span<const double> per_mass, double step) {
  std::vector<double> root(flux.bodies);
  for (std::size_t k = 0; k < root.size(); ++k)
    root[k] = std::sqrt(step * per_mass[k]);
  const auto visit = [&](const auto& entry) {
    for (std::size_t i = 0; i < flux.pores(); ++i)
      if (const int unknown = system.unknown_of_pore[i]; unknown >= 0)
        for (int c = 0; c < 4; ++c)
          if (const int body = flux.body[i][c]; root[body] > 0)
            entry(unknown, body, flux.weight[i][c]);
  };
  GramTerm::Entries rows;
  rows.start.assign(system.unknowns() + 1, 0);
  visit([&](int unknown, int, const Vec3&) { ++rows.start[unknown + 1]; });
  std::partial_sum(rows.start.begin(), rows.start.end(), rows.start.begin());
  rows.entry.resize(static_cast<std::size_t>(rows.start.back()));
  std::vector<int> next(rows.start.begin(), rows.start.end() - 1);
  visit([&](int unknown, int body, const Vec3& weight) { rows.entry[next[unknown]++] = {body, root[body] * weight}; });
  return gram_term(std::move(rows), static_cast<int>(flux.bodies));
}

} // namespace pfv
