#pragma once

#include "studies/plots/plot.hpp"

#include <string>

namespace studies {

/// A picture, or why there is none.
struct Drawing {
  std::string svg;
  std::string why_not; // a sentence without a full stop; empty with a picture
};

/// Draws with gnuplot, a process of its own, for a page: see svg_for_pages.
Drawing draw(const Plot& plot, const std::string& id_prefix);

} // namespace studies
