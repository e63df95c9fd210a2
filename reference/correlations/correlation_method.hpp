#pragma once

#include "reference/method.hpp"

namespace reference {

/// Correlations of measured or simulated permeabilities as methods: carman_kozeny, ergun, wyllie_gregory, beetstra,
/// tenneti (see drag.hpp). They answer k and the flux that follows, from solid fraction and Sauter diameter alone, and
/// no forces. Outside of the solid fractions they were made for they say so.
/// They hold for the bulk of a random packing. A box with walls has more void along them; it is answered with the solid
/// fraction of the whole box, and notes["bulk"] says that it is none. Not covered: spheres cut by walls, whose solid
/// fraction is not that of whole spheres. Overlaps are not looked for and count twice.
std::vector<std::unique_ptr<Method>> make_correlations();

} // namespace reference
