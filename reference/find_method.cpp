#include "pfv/problem/error.hpp"
#include "reference/method.hpp"

#include <algorithm>

namespace reference {

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
