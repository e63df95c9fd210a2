#pragma once

namespace reference {

// Permeability (m^2) of random beds of spheres in Stokes flow, from the solid fraction phi, 0 < phi < 1, and the Sauter
// diameter d (m). Pure formulas: where they hold is for the methods to say. Drag is told as
//   K = d^2 / (18 phi k),
// the force on a sphere, mean pressure gradient included, over 3 pi mu d U, U the superficial velocity; 1 for a sphere
// alone.

/// k = d^2 (1 - phi)^3 / (36 c phi^2), c the Kozeny constant: 5 for Carman 1937 (180 = 36 c), 25/6 for the viscous term
/// of Ergun 1952 (150), 4.5 to 5.1 for the spheres of Wyllie & Gregory 1955.
double kozeny_permeability(double solid_fraction, double diameter, double constant);

/// K = F / (1 - phi), F = 10 phi / (1 - phi)^2 + (1 - phi)^2 (1 + 3/2 sqrt(phi)) without the mean pressure gradient.
/// Beetstra, van der Hoef & Kuipers 2007, at Re = 0 that of van der Hoef, Beetstra & Kuipers 2005; equal spheres.
double beetstra_drag(double solid_fraction);

/// What K of equal spheres of the Sauter diameter is multiplied by for a sphere of `size` times that diameter among
/// others: (1 - phi) y + phi y^2 + 0.064 (1 - phi) y^3. The same sources. Not quite 1 at y = 1: by 0.064 (1 - phi).
double beetstra_size_factor(double solid_fraction, double size);

/// K = (1 + 5.81 phi) / (1 - phi)^3 + 0.48 phi^(1/3) / (1 - phi)^4: Tenneti, Garg & Subramaniam 2011 at Re = 0; equal
/// spheres.
double tenneti_drag(double solid_fraction);

/// k = d^2 / (18 phi K).
double permeability_of_drag(double solid_fraction, double diameter, double drag);

} // namespace reference
