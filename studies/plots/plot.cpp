#include "studies/plots/plot.hpp"

#include <algorithm>

namespace studies {

bool Plot::empty() const {
  return std::ranges::all_of(series, [](const Series& one) { return one.points.empty(); });
}

} // namespace studies
