#pragma once

#include "meshing/child_process.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace reference::openfoam {

/// Why the stock programs cannot be run here: not on PATH, or no OpenFOAM configuration ($WM_PROJECT_DIR, else that of
/// the Debian package). Nothing when they can.
std::optional<std::string> missing_programs();

/// "OpenFOAM 1912 (patch 200626)" as simpleFoam names itself, asked once; empty when it cannot be run.
std::string program_version();

/// Runs one program in a case folder and waits for it, its output in `log.<program>` there. The OpenFOAM environment
/// script is not needed. Throws pfv::SolveError with the end of the log when it fails or runs past the limit.
meshing::ChildResult run_program(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
                                 std::optional<double> wall_limit = std::nullopt);

/// The same on several ranks by mpirun, in a case that decomposePar has prepared, also as root and on fewer cores.
meshing::ChildResult run_on_ranks(const std::filesystem::path& folder, const std::string& program, int ranks);

} // namespace reference::openfoam
