#pragma once

#include "pfv/simulation/simulation.hpp"

namespace studies {

/// Grains under water in a box that repeats sideways, closed below; what the two studies of beds have in common.
struct Bed {
  int grains = 1000;
  double side = 0.1; // m
  double radius_ratio = 1.35;
  double density = 2600, fluid_density = 1000; // kg/m^3
  double viscosity = 2;                        // Pa s: the fluid, not inertia, holds the grains back
  double young = 1e6;                          // Pa, see LinearSprings
  double friction = 0.5;
  double gravity = 9.81; // m/s^2
  bool lubricated = false;
  unsigned seed = 1;
};

/// Gravity, buoyancy, contacts and walls; local damping is for beds that only are to come to rest.
pfv::GrainScene bed_grains(const Bed& bed, double local_damping);

/// The fluid between them: zero excess pressure above, closed or at a pressure below.
pfv::FluidScene bed_fluid(const Bed& bed, const pfv::FaceCondition& below);

/// N, of all grains less that of the water they displace.
double buoyant_weight(const Bed& bed, const pfv::Grains& grains);

/// What fluid (N) does to all grains together, upwards.
double lift(const pfv::Simulation& simulation);

/// What the floor carries of the grains, through contacts and films (N).
double on_floor(const pfv::GrainCycle& cycle);

/// Mean height of the grains (m), by mass.
double mean_height(const pfv::Grains& grains);

} // namespace studies
