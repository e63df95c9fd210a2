#pragma once

#include "pfv/flow/conductance_rules.hpp"
#include "pfv/problem/case.hpp"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace studies {

/// A packing whose permeability is known.
struct KnownPermeability {
  std::string id;
  pfv::Case problem;
  double permeability; // m^2
  double error;        // m^2
};

/// The rule `calibrated` as fitted to packings.
struct Calibration {
  pfv::Calibrated rule;
  std::array<double, 3> standard_error; // of openness, length and gap
  std::vector<double> difference;       // ln(k / k_known) by packing
  std::vector<double> left_out;         // the same by the fit to all other packings
};

/// Least squares of ln(k / k_known) over the three constants of the rule, all packings alike, by Gauss and Newton from
/// the rule's own constants. What a packing is off when it is left out is that of the problem linearised about the fit:
/// its difference over one less its leverage. Throws pfv::InputError with fewer than four packings, and
/// pfv::SolveError when it does not settle.
Calibration calibrate(std::span<const KnownPermeability> packings);

} // namespace studies
