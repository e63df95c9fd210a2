#pragma once

#include <string>

namespace studies {

/// The time it is, UTC, ISO 8601 to the second.
std::string now_utc();

} // namespace studies
