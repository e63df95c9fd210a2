#pragma once

#include "reference/answer.hpp"

namespace studies {

/// What an answer's own counts say about how far its permeability may be off, beside what falls with its mesh size.
/// Both are half widths relative to the permeability, and zero where the answer does not count what they are made of.

/// By flux that gets lost or made: a share of flux_imbalance, the largest difference of the flux between sections of
/// the box over its mean. Where spheres cut links between voxels, mass is not conserved, and both errors come and go
/// with where the voxels lie, not with their size; methods that conserve mass have 1e-7 and less. The share was chosen
/// on the lattices that lattice Boltzmann answers at mesh sizes 0.7, 0.5 and 0.35, whose bars then hold 11 of 11, and
/// those of the coarser two 12 of 13; afterwards sizes 1, 0.7 and 0.5 held 11 of 13, 1 and 0.7 14 of 14, and of four
/// other packings all (calibration.csv).
inline constexpr double noise_share = 0.75;
double noise(const reference::Answer& answer);

/// By bridges that stand for contacts, which all meshes have alike, so that no extrapolation sees what they close: a
/// share of the fluid that they take (-volume_error, where there are bridges). That counts a contact on a box face by
/// its part inside, a gap by its width and a small sphere as a small one, which a number of bridges does not. The share
/// is the largest of nine packings, from 0.04 for touching simple cubic to 0.33 for fcc spheres that just do not touch
/// (bridge_calibration.csv): the denser, the more a contact matters.
inline constexpr double bridge_share = 0.35;
double bridge_error(const reference::Answer& answer);

} // namespace studies
