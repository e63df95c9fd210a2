#include "pfv/problem/error.hpp"
#include "reference/closed_form/closed_form.hpp"
#include "reference/exact/exact.hpp"
#include "reference/method.hpp"
#include "reference/unavailable_method.hpp"

#ifdef PFV_WITH_OPENFOAM
#include "reference/openfoam/openfoam.hpp"
#endif
#ifdef PFV_WITH_PORE_VOLUMES
#include "reference/pore_volumes/pore_volumes.hpp"
#endif
#ifdef PFV_WITH_STOKES_FEM
#include "reference/stokes_fem/stokes_fem.hpp"
#endif

#include <algorithm>

namespace reference {

namespace {

std::vector<std::unique_ptr<Method>> make_methods() {
  std::vector<std::unique_ptr<Method>> list;
#ifdef PFV_WITH_PORE_VOLUMES
  list.push_back(make_pore_volumes());
  list.push_back(make_pore_volumes_sor());
#endif
#ifdef PFV_WITH_STOKES_FEM
  list.push_back(make_stokes_fem());
#else
  list.push_back(make_unavailable("stokes_fem", "Stokes flow by finite elements of order 2/1 (deal.II)",
                                  "this build has no deal.II (Debian package libdeal.ii-dev)"));
#endif
#ifdef PFV_WITH_OPENFOAM
  list.push_back(make_openfoam());
#endif
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
