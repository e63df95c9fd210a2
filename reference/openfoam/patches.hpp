#pragma once

#include "pfv/problem/face.hpp"

#include <cstddef>
#include <string>
#include <variant>

namespace reference::openfoam {

struct SphereSurface {
  std::size_t sphere;
};
struct PairBridge {
  std::size_t first, second;
};
struct WallBridge {
  std::size_t sphere;
  pfv::Face face;
};

/// What a patch of the mesh is a part of.
using Patch = std::variant<pfv::Face, SphereSurface, PairBridge, WallBridge>;

/// Reads the names meshing::void_mesh gives: `x_min`, `sphere_3`, `bridge_3_5`, `bridge_3_x_min`. Throws
/// pfv::SolveError on any other name, such as the defaultFaces of a mesh with a surface that nobody named.
Patch patch_named(const std::string& name);

} // namespace reference::openfoam
