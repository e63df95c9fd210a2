#include "pfv/problem/error.hpp"
#include "reference/closed_form/closed_form.hpp"
#include "reference/exact/exact.hpp"
#include "reference/method.hpp"
#include "reference/unavailable_method.hpp"

#include <algorithm>

// The registry of the tests, in place of the one of all methods.
namespace reference {

const std::vector<std::unique_ptr<Method>>& methods() {
  static const auto list = [] {
    std::vector<std::unique_ptr<Method>> made;
    made.push_back(make_exact());
    made.push_back(make_closed_form());
    made.push_back(make_unavailable("absent", "a method that cannot run", "not in this build"));
    return made;
  }();
  return list;
}

const Method& find_method(const std::string& name) {
  const auto found = std::ranges::find(methods(), name, [](const auto& method) { return method->name(); });
  if (found == methods().end())
    throw pfv::InputError("unknown method '" + name + "'; it can be one of exact, closed_form, absent");
  return **found;
}

} // namespace reference
