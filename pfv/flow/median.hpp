#pragma once

#include <vector>

namespace pfv {

/// The median of those values that are positive and finite, 0 when there is none: the upper one of two in the middle.
double positive_median(const std::vector<double>& values);

} // namespace pfv
