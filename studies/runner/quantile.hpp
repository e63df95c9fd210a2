#pragma once

#include <vector>

namespace studies {

/// The value below which a share q (0 to 1) of them lies, linear between neighbours; NaN of nothing.
double quantile(std::vector<double> values, double q);

} // namespace studies
