#pragma once

#include "pfv/problem/face_condition.hpp"
#include "pfv/problem/packing_file.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

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

/// A place in the box where the pressure is known: a source or sink of whatever flux that takes.
struct PressurePoint {
  Vec3 position; // m
  double value;  // Pa

  bool operator==(const PressurePoint&) const = default;
};

/// The question every method answers: steady Stokes flow through the void of a fixed packing.
struct Case {
  std::string name; // a label; not part of the question, so not of the digest
  Packing packing;
  Fluid fluid;
  FaceConditions faces;
  std::optional<Buoyancy> buoyancy;
  std::vector<PressurePoint> pressure_points = {};
  std::vector<std::string> notes = {}; // of the reader of its packing; not part of the question either

  bool operator==(const Case&) const = default;
};

/// What a permeability is measured over: k = mu Q length / (area pressure_drop). Catalano et al. 2011, eq. (11).
struct PermeabilitySetup {
  Axis axis;
  std::optional<double> pressure_drop; // Pa, upper minus lower face, not zero; part of the answer when absent
  double length;                       // m, of the box along the axis
  double area;                         // m^2, of the box across the axis
};

/// The setup when fluid is driven along one axis and by nothing else: by different pressures on its two faces, by a
/// flux on one and a pressure on the other, or by the mean gradient along a periodic axis, the other faces slip walls
/// or periodic.
std::optional<PermeabilitySetup> permeability_setup(const Case& problem);

/// Throws InputError on the first thing no method can work with.
void validate(const Case& problem);

/// Reads a case from TOML; a `file` in it is relative to the TOML file. Throws InputError (file, line, value, what is
/// allowed); unknown keys are errors that name the valid ones, but [pfv] belongs to the solver and is left to it. The
/// result is validated.
Case read_case(const std::filesystem::path& file);

/// What a command line says about the question; it wins over the file.
struct QuestionOptions {
  std::optional<Axis> axis;             // of the flow
  std::optional<PeriodicAxes> periodic; // axes along which the box repeats
  std::optional<double> viscosity;      // Pa s
  PackingFileOptions packing = {};
};

/// Whether read_question takes the file for a case: its name ends in .toml.
bool is_case_file(const std::filesystem::path& file);

/// Reads a case, or a bare packing through which fluid flows along z under a drop of 1 Pa. Throws InputError.
Case read_question(const std::filesystem::path& file, const QuestionOptions& options);

/// The whole case as TOML, spheres included, every number with the digits that read back to the same double.
std::string to_toml(const Case& problem);

/// 32 hexadecimal digits that change when and only when the question does (the name is not part of it).
std::string digest(const Case& problem);

} // namespace pfv
