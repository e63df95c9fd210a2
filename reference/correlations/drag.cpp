#include "reference/correlations/drag.hpp"

#include <cmath>

namespace reference {

double kozeny_permeability(double solid_fraction, double diameter, double constant) {
  const double porosity = 1 - solid_fraction;
  return diameter * diameter * std::pow(porosity, 3) / (36 * constant * solid_fraction * solid_fraction);
}

double beetstra_drag(double solid_fraction) {
  const double porosity = 1 - solid_fraction;
  const double without_gradient =
      10 * solid_fraction / (porosity * porosity) + porosity * porosity * (1 + 1.5 * std::sqrt(solid_fraction));
  return without_gradient / porosity;
}

double beetstra_size_factor(double solid_fraction, double size) {
  const double porosity = 1 - solid_fraction;
  return porosity * size + solid_fraction * size * size + 0.064 * porosity * size * size * size;
}

double tenneti_drag(double solid_fraction) {
  const double porosity = 1 - solid_fraction;
  return (1 + 5.81 * solid_fraction) / std::pow(porosity, 3) + 0.48 * std::cbrt(solid_fraction) / std::pow(porosity, 4);
}

double permeability_of_drag(double solid_fraction, double diameter, double drag) {
  return diameter * diameter / (18 * solid_fraction * drag);
}

} // namespace reference
