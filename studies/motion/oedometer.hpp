#pragma once

#include "pfv/simulation/simulation.hpp"

#include <functional>
#include <string>
#include <vector>

namespace studies {

/// The oedometer of Catalano et al. 2011, section 7: grains under a piston, drained at both ends. The box repeats
/// sideways: walls there would be a second way out, as the layer of pores along them is two to three times as
/// permeable.
struct Oedometer {
  int grains = 5000;
  double side = 0.1;              // m, of the cube before it is compacted
  double radius_ratio = 1.35;     // largest / smallest
  double young = 1e7;             // Pa, see LinearSprings
  double friction = 0.5;          // during the test,
  double friction_prepared = 0.1; // and while compacted: dense, and far from sliding afterwards, so that it is elastic
  double confining_stress = 50e3; // Pa
  double load = 5e3;              // Pa, what is added at once
  double duration = 1;            // s, of T = 1: long against the 12 ms in which the piston would swing
  unsigned seed = 1;
};

/// The layer at rest under the confining stress, dry.
pfv::GrainCycle compacted(const Oedometer& test, pfv::Clock& clock);

/// The load on it and a fluid (Pa s) between the grains; semi-implicit. The scene has no packing: start from the layer.
pfv::Scene under_load(const Oedometer& test, double viscosity);

/// What is known of the layer before the test, all of it measured.
struct Layer {
  double height = 0;              // m
  double porosity = 0;            // volume of the void over that of the box
  double permeability = 0;        // m^2, by the gradient between the drained planes
  double permeability_of_box = 0; // m^2, by the drop over the height
  /// Where the straight line of pressures in the middle of the permeability test meets the imposed ones, as shares of
  /// the height: pores at a drained wall are at its pressure, so drained planes lie inside of the walls.
  double lower = 0, upper = 1;
  double final_settlement = 0; // m, in a slow dry step of the load
  double share_of_ends = 0;    // of it, in pores held at the drained walls' pressure: settles at once
  double compressibility = 0;  // 1/Pa, m_v: the rest of it over load and drained length
  double nonlinearity = 0;     // settlement at half of the load, over half of the final one, less 1
  double viscosity = 0;        // Pa s, such that T = 1 after `duration`

  double drained_length() const { return (upper - lower) * height; }
  /// m^2/s, c_v = k / (mu m_v)
  double consolidation() const { return permeability / (viscosity * compressibility); }
  /// T after a time (s).
  double time_factor(double time) const {
    return consolidation() * time / (0.25 * drained_length() * drained_length());
  }
};

/// The layer at some time of the test, everything relative to the load and to the final settlement.
struct Moment {
  double time_factor = 0;
  double settlement = 0;        // of the piston
  double middle_pressure = 0;   // mean over the middle tenth of the height, by volume of void
  std::vector<double> pressure; // the same of equal slices from the bottom to the top
};

struct Consolidation {
  Layer layer;
  std::vector<Moment> moments;
  std::size_t steps = 0;
  double step = 0;          // s
  double contact_limit = 0; // s
  double energy_error = 0;  // what the energy balance misses, over the work of the load
  std::vector<pfv::Stage> stages;
};

/// Compacts, measures, loads and lets the layer consolidate until the last of the time factors, ascending. `say` is
/// told what is being done and how much of it is done, 0 ... 1.
Consolidation consolidate(const Oedometer& test, const std::vector<double>& time_factors,
                          const std::function<void(const std::string&, double)>& say);

} // namespace studies
