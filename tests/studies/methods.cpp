#include "reference/closed_form/closed_form.hpp"
#include "reference/exact/exact.hpp"
#include "reference/method.hpp"
#include "reference/unavailable_method.hpp"

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

} // namespace reference
