#pragma once

#include "reference/method.hpp"

namespace reference {

/// Cubic lattices of equal spheres in Stokes flow along an axis, from the tabulated drag coefficients of
/// lattice_drag.csv (Zick & Homsy 1982, and fundamental solutions with more digits). A case is recognised by its
/// packing: that of pfv::lattice_packing, spheres in any order, anywhere in space, at a tabulated solid fraction.
///   k = d^2 / (18 phi K)
/// Every sphere carries |grad p| times its share of the box, a cut sphere in proportion to the part inside; components
/// across the flow vanish by symmetry. counts["relative_error"] is the error bar of k.
std::unique_ptr<Method> make_closed_form();

} // namespace reference
