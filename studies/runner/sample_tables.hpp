#pragma once

#include "pfv/problem/case.hpp"
#include "studies/runner/finding.hpp"

#include <string>

namespace studies {

/// What a method found at every place of PFV's, as CSV without heads, a line for each case, sphere, pore and throat. An
/// empty field is unknown: a pore's centre in the solid, an error of one mesh.
struct SampleTables {
  static constexpr const char* permeabilities_head =
      "case,spheres,solid_fraction,permeability_m2,error_m2,pressure_drop_Pa,rms_error_force_N,rms_error_pressure_Pa,"
      "rms_error_flux_m3_s\n";
  static constexpr const char* forces_head = "case,x,y,z,radius,force_x_N,force_y_N,force_z_N\n";
  static constexpr const char* pores_head = "case,x,y,z,void_volume_m3,pressure_Pa\n";
  /// Pores by their place in the case; the flux from i to j; the rise of the pressure to the box that j is met in.
  static constexpr const char* throats_head =
      "case,pore_i,pore_j,walls,area_m2,fluid_area_m2,void_volume_m3,wetted_surface_m2,length_m,flux_m3_s,"
      "pressure_rise_Pa\n";

  std::string permeabilities, forces, pores, throats;
};

/// Adds a case. The finding must have samples (`samples = true` in its study). Throws pfv::InputError when it has none
/// or when they are of other pores, as after a change of how PFV numbers them.
void add_samples(const pfv::Case& problem, const Finding& finding, SampleTables& tables);

} // namespace studies
