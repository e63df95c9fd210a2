#pragma once

#include "reference/method.hpp"

namespace reference {

/// Stands for a method this build does not contain, so that tables say "unavailable" and why instead of losing a row.
std::unique_ptr<Method> make_unavailable(std::string name, std::string description, std::string reason);

} // namespace reference
