#pragma once

#include "meshing/linear_mesh.hpp"

#include <filesystem>

namespace meshing::testing {

/// Reads the MSH 2.2 that write_msh writes, independently of it. Throws std::runtime_error on anything else.
LinearMesh read_msh(const std::filesystem::path& file);

} // namespace meshing::testing
