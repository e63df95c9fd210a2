#pragma once

#include "pfv/clock.hpp"
#include "pfv/problem/vec3.hpp"

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace reference {

/// How the names of stages begin that time one more step of a moving packing (topology kept, everything else renewed or
/// kept as the method does it) instead of the answer itself. They are beside the cost of the answer, not part of it.
inline const std::string repeat_prefix = "repeat: ";

/// The count that says what the method needed at its largest, in bytes, apart from the libraries and the input. A
/// method that knows better than its caller can measure gives it itself.
inline constexpr const char* memory_count = "memory_bytes";

/// The counts that whoever asks for samples adds: how many of the points, from the first, are pores; and what the
/// pressures are to be measured by (Pa).
inline constexpr const char* sampled_pores_count = "sampled_pores";
inline constexpr const char* pressure_drop_count = "pressure_drop";

/// The count of a method that judges a packing by its Sauter diameter (m).
inline constexpr const char* sauter_diameter_count = "sauter_diameter";

/// What a method says about a Case: the common currency of all comparisons. A quantity a method does not compute is
/// absent, never zero. SI units.
struct Answer {
  std::string method;
  double mesh_size = 1;               // of the Request asked for; 1 for methods without a mesh
  std::size_t unknowns = 0;           // degrees of freedom of the largest system solved
  std::optional<double> permeability; // m^2
  std::array<double, 6> face_flux{};  // m^3/s by pfv::Face, positive out of the box
  std::optional<double> porosity;     // of the geometry actually solved
  /// N, of the flow (piezometric pressure and viscous), no buoyancy. A sphere cut by a pressure face also bears that
  /// face's pressure on the disc cut out of it, so that between slip walls the forces add up to the pressure drop times
  /// the area of the box; one centred on a slip wall is half of a mirrored pair, with no force normal to the wall.
  std::optional<std::vector<pfv::Vec3>> sphere_forces;
  std::optional<std::vector<pfv::Vec3>> sphere_viscous_forces; // N, of these, the part of the shear on the surface
  std::optional<std::array<pfv::Vec3, 6>> wall_forces;         // N, by pfv::Face, of the fluid on the face
  std::optional<std::vector<double>> point_pressures; // Pa, at Probes::points; NaN in the solid and where unknown
  std::optional<std::vector<double>> facet_fluxes; // m^3/s, through Probes::facets along their normals; NaN if unknown
  std::vector<pfv::Stage>
      stages; // CPU seconds by stage, once-per-mesh stages marked by name "mesh", see also repeat_prefix
  std::map<std::string, double> counts; // remedies and checks: contracted_throats, bridges, iterations, flux_imbalance
  std::map<std::string, std::string> notes; // versions, settings, anything a reader needs to judge the number
};

/// One JSON object, numbers with the digits that read back to the same double; from_json(to_json(a)) gives a.
std::string to_json(const Answer& answer);
Answer answer_from_json(const std::string& text);

} // namespace reference
