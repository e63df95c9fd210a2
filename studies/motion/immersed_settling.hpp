#pragma once

#include "studies/motion/bed.hpp"
#include "studies/motion/experiment.hpp"

namespace studies {

/// A suspension at some time, forces over the buoyant weight.
struct SettlingMoment {
  double time = 0;           // s
  double floor_pressure = 0; // excess pressure at the floor times its area
  double on_floor = 0;       // carried by the floor through contacts
  double lift = 0;           // of the fluid on all grains
  double mean_height = 0;    // over that at the start
  double speed = 0;          // m/s, mean, downwards
};

struct Settling {
  Bed bed;
  double solid_fraction = 0; // of the suspension
  double permeability = 0;   // m^2, of the suspension at the start
  double expected_speed = 0; // m/s, k (1-n) (rho_s - rho_f) g / mu: no net flux through any level
  std::vector<SettlingMoment> moments;
  double bed_porosity = 0; // in the middle of the bed at the end
  std::size_t steps = 0, rebuilt = 0;
  std::vector<pfv::Stage> stages;
};

/// Lets a uniform suspension settle until it rests.
Settling settle(const Bed& bed, double solid_fraction, const Say& say);

ExperimentReport settling_report(const Settling& test);
ExperimentReport run_immersed_settling(bool quick, const Say& say);

inline constexpr Experiment settling_experiment{
    "immersed_settling",
    "A suspension settles into a bed: excess pressure carries the buoyant weight, then contacts do",
    "Does the pressure below a settling suspension carry its buoyant weight until contacts do, and all of it at any "
    "time?",
    run_immersed_settling};

} // namespace studies
