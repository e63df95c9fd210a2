#pragma once

#include "pfv/problem/face.hpp"
#include "pfv/problem/packing.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace pfv {

struct Fluid {
  double viscosity = 1.0; // Pa s

  bool operator==(const Fluid&) const = default;
};

/// Weight of the displaced fluid, - rho_f g V per sphere. Apart from the flow, whose pressure is piezometric.
struct Buoyancy {
  double fluid_density; // kg/m^3
  Vec3 gravity;         // m/s^2

  bool operator==(const Buoyancy&) const = default;
};

/// The question every method answers: steady Stokes flow through the void of a fixed packing.
struct Case {
  std::string name; // a label; not part of the question, so not of the digest
  Packing packing;
  Fluid fluid;
  FaceConditions faces;
  std::optional<Buoyancy> buoyancy;

  bool operator==(const Case&) const = default;
};

/// Flow along `axis` from the upper face at `pressure_drop` (Pa) to the lower face at zero, slip walls around.
FaceConditions flow_along(Axis axis, double pressure_drop = 1.0);

/// What a permeability is measured over: k = mu Q length / (area pressure_drop). Catalano et al. 2011, eq. (11).
struct PermeabilitySetup {
  Axis axis;
  double pressure_drop; // Pa, upper minus lower face, not zero
  double length;        // m, of the box along the axis
  double area;          // m^2, of the box across the axis
};

/// The setup when exactly two opposite faces carry different pressures and the other four are slip walls.
std::optional<PermeabilitySetup> permeability_setup(const Case& problem);

/// Reads a case from TOML; a `file` in it is relative to the TOML file. Throws InputError (file, line, value, what is
/// allowed); unknown keys are errors that name the valid ones. The result is validated.
Case read_case(const std::filesystem::path& file);

/// The whole case as TOML, spheres included, every number with the digits that read back to the same double.
std::string to_toml(const Case& problem);

/// Throws InputError on the first thing no method can work with.
void validate(const Case& problem);

/// 32 hexadecimal digits that change when and only when the question does (the name is not part of it).
std::string digest(const Case& problem);

} // namespace pfv
