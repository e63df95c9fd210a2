#pragma once

#include "pfv/grains/contact_list.hpp"

namespace pfv {

/// Radii that grow together in a box that stays, until the grains press one another as asked: a packing at an isotropic
/// stress, of any friction, without walls that move.
struct Growth {
  double rate;   // 1/s, of the radii while nothing presses
  double stress; // Pa, mean of the three normal stresses, compression positive

  bool operator==(const Growth&) const = default;
};

/// Mean normal stress of contacts (Pa, compression positive). At rest that on the walls, if there are any.
double mean_stress(const Eigen::Matrix3d& stress);

/// Of the radii at a mean stress (Pa): 1/s, in proportion to what is missing of the one that is asked for. Beyond it
/// they shrink again, no faster than they may grow.
double growth_rate(const Growth& growth, double mean_stress);

/// Multiplies all radii by a factor at a density (kg/m^3); centres and velocities stay. The radii are those that grains
/// began with times one number, so their ratios never change. Throws InputError when a periodic box gets too narrow for
/// them.
void grow(Grains& grains, double factor, double density);

/// Work (J) that it takes: what springs of contacts store and grains have in motion then, less what they do now.
double growth_work(const Grains& grains, const std::vector<Contact>& contacts, const ContactLaw& law, double factor);

} // namespace pfv
