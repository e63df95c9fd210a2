#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace reference::yade {

/// Why the stock program cannot be run here; nothing when it can.
std::optional<std::string> missing_program();

/// "YADE 2023.02a" as it names itself, asked once; empty when it cannot be run.
std::string program_version();

/// Runs a script of the folder without display, prompt after it or threads, its output in `log` there. Throws
/// pfv::SolveError with the end of the log when it crashes, fails or runs past `wall_limit` (s).
void run_script(const std::filesystem::path& folder, const std::string& script, double wall_limit);

} // namespace reference::yade
