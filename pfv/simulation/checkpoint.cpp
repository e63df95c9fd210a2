#include "pfv/simulation/checkpoint.hpp"

#include "pfv/problem/error.hpp"
#include "pfv/problem/text.hpp"
#include "pfv/simulation/simulation.hpp"

#include <fmt/format.h>

namespace pfv {

void require_same_grains(const Checkpoint& checkpoint, const Scene& scene) {
  const auto differ = [](const std::string& what, const auto& saved, const auto& here) {
    throw InputError(
        fmt::format("the checkpoint is of other grains: {} \"{}\" there, \"{}\" in the scene", what, saved, here));
  };
  const Grains& grains = checkpoint.grains;
  const auto& spheres = scene.packing.spheres;
  if (grains.size() != spheres.size())
    differ("grains", grains.size(), spheres.size());
  for (std::size_t i = 0; i < grains.size(); ++i) {
    const Sphere& sphere = spheres[grains.number[i]];
    const double radius = grains.first_radius.empty() ? grains.sphere(i).radius : grains.first_radius[i];
    if (radius != sphere.radius)
      differ(fmt::format("radius of sphere {}", grains.number[i]), shortest(radius), shortest(sphere.radius));
    if (const double mass = scene.grains.density * volume(grains.sphere(i)); grains.mass[i] != mass)
      differ(fmt::format("mass of sphere {}", grains.number[i]), shortest(grains.mass[i]), shortest(mass));
  }
  for (int axis = 0; axis < 3; ++axis)
    if (grains.periodic[axis] != scene.grains.walls.periodic[axis])
      differ(fmt::format("axis {}", axis_names[axis]), grains.periodic[axis] ? "periodic" : "with walls",
             scene.grains.walls.periodic[axis] ? "periodic" : "with walls");
  if (checkpoint.cohesion.has_value() != scene.grains.cohesion.has_value())
    differ("cohesion", checkpoint.cohesion ? "present" : "absent", scene.grains.cohesion ? "present" : "absent");
}

} // namespace pfv
