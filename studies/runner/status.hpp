#pragma once

#include <array>
#include <string>
#include <string_view>

namespace studies {

/// What became of one run.
enum class Status { answered, not_covered, unavailable, over_budget, failed };

inline constexpr std::array all_statuses{Status::answered, Status::not_covered, Status::unavailable,
                                         Status::over_budget, Status::failed};

/// "answered", "not covered", "unavailable", "not run: over budget", "failed".
std::string_view name(Status status);

/// Throws pfv::InputError naming the valid names.
Status status_from(std::string_view name);

} // namespace studies
