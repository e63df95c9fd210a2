#pragma once

#include "pfv/problem/case.hpp"

#include <optional>
#include <string>

namespace reference {

/// What a case asks for beyond slip walls and faces at one pressure each, in words for Method::not_covered; nothing
/// when that is all.
std::optional<std::string> beyond_walls_and_pressures(const pfv::Case& problem);

} // namespace reference
