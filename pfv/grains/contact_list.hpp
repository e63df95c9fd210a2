#pragma once

#include "pfv/grains/contacts.hpp"

#include <vector>

namespace pfv {

/// A contact as it is now, for looking at it.
struct Contact {
  int first;
  int second;     // another grain, or -1 - index(Face)
  Vec3 normal;    // to the second
  double overlap; // m
  double radius;  // m, reduced
  Vec3 shear;     // N, on the first
  bool cemented;
};

/// Every contact once: of grains with grains, then with walls.
std::vector<Contact> contact_list(const Grains& grains, const Contacts& contacts);

/// J, in all springs.
double elastic_energy(const Grains& grains, const Contacts& contacts);

/// Part of the contacts in the mean stress of the grains (Pa, compression negative): sum over contacts of force times
/// branch, over the volume of the box. Love (1927), Weber (1966).
Eigen::Matrix3d contact_stress(const Grains& grains, const Contacts& contacts);
Eigen::Matrix3d contact_stress(const Grains& grains, const std::vector<Contact>& contacts, const ContactLaw& law);

/// Square of the fastest circular frequency (1/s^2) of the contacts' springs between the grains' masses and inertias,
/// by power iteration; walls at rest. Where a grain has no contact it counts as one with its like that overlaps by 1 %.
double largest_square_frequency(const Grains& grains, const Contacts& contacts);

} // namespace pfv
