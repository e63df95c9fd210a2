#pragma once

#include <string>

namespace reference {

/// Whether a program of this name can be run from a folder of $PATH.
bool on_path(const std::string& program);

} // namespace reference
