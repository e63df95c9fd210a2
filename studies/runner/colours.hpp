#pragma once

#include <string>

namespace studies {

struct Colour {
  double red, green, blue; // 0 ... 255
};

/// For shares from 0 to 1: from violet over green to yellow, lighter all the way.
Colour colour_of(double share);

/// For -1 to 1: from blue over nearly white to red.
Colour diverging_colour_of(double share);

/// As SVG has it; lighter above one, darker below.
std::string lit(const Colour& colour, double light);

} // namespace studies
