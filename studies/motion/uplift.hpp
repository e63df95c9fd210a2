#pragma once

#include "studies/motion/bed.hpp"
#include "studies/motion/experiment.hpp"

namespace studies {

/// A bed under an upward flow at some time.
struct UpliftMoment {
  double gradient = 0; // of excess pressure in the middle of the bed over the weight of water per volume, i
  double on_floor = 0; // carried by the floor through contacts, over the buoyant weight
  double lift = 0;     // of the fluid on all grains, over it
  double rise = 0;     // of the mean height, in mean diameters
};

struct Uplift {
  Bed bed;
  double porosity = 0;   // in the middle of the bed, before
  double height = 0;     // m, of the bed: where its highest tenth begins
  double critical = 0;   // (1 - n) (G_s - 1), Terzaghi
  double carried_at = 0; // gradient at which the fluid carries the whole weight
  double risen_at = 0;   // gradient at which the bed has risen by a hundredth of a diameter
  std::vector<UpliftMoment> moments;
  std::size_t steps = 0;
  std::vector<pfv::Stage> stages;
};

/// Raises the pressure below a bed at rest, slowly, until it has risen.
Uplift lift_up(const Bed& bed, const Say& say);

ExperimentReport uplift_report(const Uplift& test);
ExperimentReport run_uplift(bool quick, const Say& say);

inline constexpr Experiment uplift_experiment{
    "uplift", "A bed lifted by an upward flow, against the critical gradient (1 - n)(G_s - 1)",
    "Does an upward flow lift a bed of grains at the critical gradient, where it carries the whole buoyant weight?",
    run_uplift};

} // namespace studies
