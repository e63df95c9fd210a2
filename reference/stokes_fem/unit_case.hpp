#pragma once

#include "pfv/problem/case.hpp"

namespace reference::stokes_fem {

/// A case in units of its own: longest side of the box, largest pressure difference (or rise of the mean pressure
/// across a periodic box) and viscosity are one, so that no tolerance depends on the units of the question.
struct UnitCase {
  pfv::Case problem;           // box from the origin; pressures absolute
  pfv::FaceConditions driving; // the same pressures less the lowest one, between 0 and 1
  double lowest_pressure = 0;  // in units of `pressure`
  pfv::Vec3 origin;            // m
  double length = 1;           // m
  double pressure = 1;         // Pa
  double viscosity = 1;        // Pa s

  double flux() const { return pressure * length * length * length / viscosity; } // m^3/s
  double force() const { return pressure * length * length; }                     // N
};

UnitCase unit_case(const pfv::Case& problem);

} // namespace reference::stokes_fem
