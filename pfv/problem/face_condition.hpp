#pragma once

#include "pfv/problem/face.hpp"
#include "pfv/problem/packing.hpp"

#include <array>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

namespace pfv {

/// Frictionless impermeable wall: u.n = 0 and no shear traction, so the wall is a plane of symmetry.
struct SlipWall {
  bool operator==(const SlipWall&) const = default;
};

/// What the fluid does along an open plane: `zero`, it may only cross it, as if a fine grid stood there; `free`, no
/// shear traction holds it back (du_t/dn = 0).
enum class Tangential { zero, free };
inline constexpr std::array<std::string_view, 2> tangential_names{"zero", "free"};

/// Open plane at a fixed piezometric pressure. With zero tangential velocity, as div u = 0, the normal viscous traction
/// vanishes there and p is the whole normal traction; with a free one p - mu du_n/dn is held at the value. Pore-scale
/// models know no difference.
struct Pressure {
  double value; // Pa
  Tangential tangential = Tangential::zero;

  bool operator==(const Pressure&) const = default;
};

/// Open plane like Pressure whose pressure varies with one coordinate: linear between the points, constant beyond them.
struct PressureProfile {
  struct Point {
    double position; // m, coordinate along the axis
    double pressure; // Pa

    bool operator==(const Point&) const = default;
  };

  Axis along;
  std::vector<Point> points; // at least one, positions increasing

  /// Pa, at a coordinate (m).
  double at(double position) const;
  bool operator==(const PressureProfile&) const = default;
};

/// Open plane at one pressure, the one at which this flux passes: an ideal pump behind a porous plate.
struct Flux {
  double value; // m^3/s, into the box

  bool operator==(const Flux&) const = default;
};

/// The box repeats along the face's axis and the pressure rises by gradient times its length from one box to the next.
/// Opposite faces are both periodic, with the same gradient.
struct Periodic {
  double gradient = 0; // Pa/m, the mean of dp/dx along the axis

  bool operator==(const Periodic&) const = default;
};

using FaceCondition = std::variant<SlipWall, Pressure, PressureProfile, Flux, Periodic>;
using FaceConditions = std::array<FaceCondition, 6>; // by index(Face)

/// What the pressure of a Pressure face is in a run: linear between the points, constant before and after them. A case
/// is steady and has none.
struct PressureInTime {
  struct Point {
    double time;     // s
    double pressure; // Pa

    bool operator==(const Point&) const = default;
  };

  std::vector<Point> points; // at least one, times increasing

  /// Pa, at a time (s).
  double at(double time) const;
  bool operator==(const PressureInTime&) const = default;
};

using PressuresInTime = std::array<std::optional<PressureInTime>, 6>; // by index(Face)

/// The axes whose lower face is Periodic.
PeriodicAxes periodic_axes(const FaceConditions& faces);

/// Mean pressure gradient (Pa/m) that the periodic faces impose; zero along the other axes.
Vec3 imposed_gradient(const FaceConditions& faces);

/// Flow along `axis` from the upper face at `pressure_drop` (Pa) to the lower face at zero, slip walls around.
FaceConditions flow_along(Axis axis, double pressure_drop = 1.0, Tangential tangential = Tangential::zero);

/// The same in a box that repeats along some axes: these have neither walls nor, if `axis` is one, faces at a pressure,
/// but the mean gradient that makes the drop over the length of the box.
FaceConditions flow_along(Axis axis, double pressure_drop, const PeriodicAxes& periodic, const Box& box,
                          Tangential tangential = Tangential::zero);

} // namespace pfv
