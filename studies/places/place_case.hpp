#pragma once

#include "pfv/pores/pore_network.hpp"
#include "pfv/problem/case.hpp"
#include "studies/runner/result.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace studies {

/// What a method says at the places of one kind in a case, beside the reference.
struct PlacePairs {
  std::string method;
  std::vector<double> values, reference; // one length; NaN where unknown
};

/// A case that the reference answered, for its places to be looked at one by one.
struct PlaceCase {
  const StudyCase& one;
  pfv::Case problem;
  pfv::PoreNetwork network; // with openings
  pfv::Axis axis;           // of the flow
  double rise;              // Pa, along the axis from one end of the box to the other
  const Finding& reference;
  std::vector<const Finding*> others; // that answered, in the study's order

  /// Pa, in the pores. Where nothing sets the level of the pressure, at the reference's mean.
  std::vector<PlacePairs> pressures() const;
  /// N, on the spheres, along the flow from high to low pressure.
  std::vector<PlacePairs> forces() const;
  /// The part of it that the shear on the surface has, of methods that tell it.
  std::vector<PlacePairs> viscous_forces() const;
  /// m^3/s, through the throats.
  std::vector<PlacePairs> fluxes() const;
  /// m^3/(Pa s), of the throats: flux over what the pressures of the same method fall by from pore to pore. NaN where
  /// the reference's flux or fall is less than three times its error, and between pores at one place.
  std::vector<PlacePairs> conductances() const;
};

/// The cases of a study with samples that the reference answered, pores and throats made anew. Throws pfv::InputError
/// when these are not the ones the answers are of.
std::vector<PlaceCase> place_cases(const Study& study, std::span<const Result> results);

} // namespace studies
