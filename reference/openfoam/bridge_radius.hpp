#pragma once

namespace reference::openfoam {

/// Of the cylinders that stand for contacts, in units of the smaller sphere radius: the same in every mesh, so that
/// every method sees the same geometry.
inline constexpr double bridge_radius = 0.15;

} // namespace reference::openfoam
