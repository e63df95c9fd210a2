#pragma once

#include "pfv/problem/face.hpp"
#include "pfv/problem/packing.hpp"

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <variant>

namespace reference::stokes_fem {

struct BoxFace {
  pfv::Face face;

  bool operator==(const BoxFace&) const = default;
};

struct SphereSurface {
  std::size_t sphere; // index in the packing

  bool operator==(const SphereSurface&) const = default;
};

/// The cylinder that stands for a contact: from a sphere to another sphere or to a wall.
struct Bridge {
  std::size_t sphere;
  std::variant<std::size_t, pfv::Face> other;

  bool operator==(const Bridge&) const = default;
};

/// What a piece of the mesh's boundary is a part of.
using BoundaryLabel = std::variant<BoxFace, SphereSurface, Bridge>;

/// By boundary id of the mesh, which is the number of the physical group.
using BoundaryLabels = std::map<unsigned, BoundaryLabel>;

/// The label a physical group's name stands for: `x_min` ... `z_max`, `sphere_K`, `bridge_I_J`, `bridge_K_x_min`.
/// Throws pfv::SolveError on any other name and on an index that is not below `spheres`.
BoundaryLabel label_of(const std::string& group, std::size_t spheres);

/// The labels of all surface groups in the $PhysicalNames of a gmsh MSH 2.2 ASCII file.
/// Throws pfv::SolveError when the file cannot be read or has no such section.
BoundaryLabels read_labels(const std::filesystem::path& mesh, std::size_t spheres);

} // namespace reference::stokes_fem
