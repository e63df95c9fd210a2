#include "reference/closed_form/closed_form.hpp"
#include "reference/correlations/correlation_method.hpp"
#include "reference/exact/exact.hpp"
#include "reference/lattice_boltzmann/lattice_boltzmann.hpp"
#include "reference/method.hpp"
#include "reference/openfoam/openfoam.hpp"
#include "reference/pore_volumes/pore_volumes.hpp"
#include "reference/stokes_fem/stokes_fem.hpp"
#include "reference/yade/yade.hpp"

namespace reference {

namespace {

std::vector<std::unique_ptr<Method>> make_methods() {
  std::vector<std::unique_ptr<Method>> list;
  list.push_back(make_pore_volumes());
  list.push_back(make_pore_volumes_sor());
  list.push_back(make_pore_volumes_loose());
  list.push_back(make_pore_volumes_mixed_area());
  list.push_back(make_pore_volumes_calibrated());
  list.push_back(make_pore_volumes_original_walls());
  list.push_back(make_yade());
  list.push_back(make_stokes_fem());
  list.push_back(make_openfoam());
  list.push_back(make_openfoam_snappy());
  list.push_back(make_lattice_boltzmann());
  list.push_back(make_closed_form());
  for (auto& correlation : make_correlations())
    list.push_back(std::move(correlation));
  list.push_back(make_exact());
  return list;
}

} // namespace

const std::vector<std::unique_ptr<Method>>& methods() {
  static const auto list = make_methods();
  return list;
}

} // namespace reference
