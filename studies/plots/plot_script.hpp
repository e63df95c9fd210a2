#pragma once

#include "studies/plots/plot.hpp"

#include <string>

namespace studies {

/// The gnuplot commands that draw a plot into the file `plot.svg`, data included. On a logarithmic axis what is not
/// positive is left out and an error bar that reaches zero ends at the edge.
std::string plot_script(const Plot& plot);

} // namespace studies
