#pragma once

#include "readme/numbers.hpp"

#include <functional>
#include <string_view>

namespace readme {

/// The value of an expression of + - * / ( ) over numbers; two that stand side by side are multiplied. `is_known` is
/// asked of each but 1, 2, 60, 100 and 1000. Throws std::runtime_error that names what is not known or not understood.
double derive(std::string_view expression, const std::function<bool(const Number&)>& is_known);

} // namespace readme
