#include "pfv/problem/error.hpp"
#include "reference/exact/exact.hpp"
#include "reference/openfoam/openfoam.hpp"

#include <algorithm>

// The registry of the fault tests, in place of the one of all methods.
namespace reference {

const std::vector<std::unique_ptr<Method>>& methods() {
  static const auto list = [] {
    std::vector<std::unique_ptr<Method>> made;
    made.push_back(make_openfoam());
    made.push_back(make_openfoam_snappy());
    made.push_back(make_exact());
    return made;
  }();
  return list;
}

const Method& find_method(const std::string& name) {
  const auto found = std::ranges::find(methods(), name, [](const auto& method) { return method->name(); });
  if (found == methods().end())
    throw pfv::InputError("unknown method '" + name + "'; it can be one of openfoam, openfoam_snappy, exact");
  return **found;
}

} // namespace reference
