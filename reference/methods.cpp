#include "pfv/problem/error.hpp"
#include "reference/closed_form/closed_form.hpp"
#include "reference/exact/exact.hpp"
#include "reference/lattice_boltzmann/lattice_boltzmann.hpp"
#include "reference/method.hpp"
#include "reference/openfoam/openfoam.hpp"
#include "reference/pore_volumes/pore_volumes.hpp"
#include "reference/stokes_fem/stokes_fem.hpp"
#include "reference/yade/yade.hpp"

#include <algorithm>

namespace reference {

namespace {

std::vector<std::unique_ptr<Method>> make_methods() {
  std::vector<std::unique_ptr<Method>> list;
  list.push_back(make_pore_volumes());
  list.push_back(make_pore_volumes_sor());
  list.push_back(make_yade());
  list.push_back(make_stokes_fem());
  list.push_back(make_openfoam());
  list.push_back(make_openfoam_snappy());
  list.push_back(make_lattice_boltzmann());
  list.push_back(make_closed_form());
  list.push_back(make_exact());
  return list;
}

} // namespace

const std::vector<std::unique_ptr<Method>>& methods() {
  static const auto list = make_methods();
  return list;
}

const Method& find_method(const std::string& name) {
  const auto found = std::ranges::find(methods(), name, [](const auto& method) { return method->name(); });
  if (found != methods().end())
    return **found;
  std::string valid;
  for (const auto& method : methods())
    valid += (valid.empty() ? "" : ", ") + method->name();
  throw pfv::InputError("unknown method '" + name + "'; it can be one of " + valid);
}

} // namespace reference
