#pragma once

#include "pfv/flow/conductance_rules.hpp"
#include "studies/calibration/known_flow.hpp"

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace studies {

/// A constant of the rule `calibrated` that is fitted.
struct FittedConstant {
  std::string_view name;
  double pfv::Calibrated::*value;
};

inline constexpr std::array fitted_constants{
    FittedConstant{"openness", &pfv::Calibrated::openness}, FittedConstant{"length", &pfv::Calibrated::length},
    FittedConstant{"gap", &pfv::Calibrated::gap}, FittedConstant{"half_gap", &pfv::Calibrated::half_gap},
    FittedConstant{"contrast", &pfv::Calibrated::contrast}};

/// The rule `calibrated` as fitted to packings.
struct Calibration {
  pfv::Calibrated rule;
  std::array<double, fitted_constants.size()> standard_error;
  std::vector<double> difference; // ln(k / k_known) by packing
  std::vector<double> left_out;   // the same by the fit to all other packings
};

/// Least squares of ln(k / k_known) over the fitted constants of the rule, all packings alike, by Gauss and Newton from
/// the rule's own constants. What a packing is off when it is left out is that of the problem linearised about the fit:
/// its difference over one less its leverage. Throws pfv::InputError with no more packings than
/// constants, and pfv::SolveError when it does not settle.
Calibration calibrate(std::span<const KnownFlow> packings);

} // namespace studies
