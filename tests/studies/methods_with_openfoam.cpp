#include "reference/exact/exact.hpp"
#include "reference/openfoam/openfoam.hpp"

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

} // namespace reference
