#include "pfv/simulation/drained_box.hpp"

#include "pfv/problem/generate.hpp"

namespace pfv {

Scene drained_box(int grains, double radius_ratio, double viscosity) {
  Scene scene;
  scene.packing = random_packing({.spheres = grains, .solid_fraction = 0.5, .radius_ratio = radius_ratio, .seed = 2});
  scene.grains.law = LinearSprings{1e6, 0.5, {0.5, 0}};
  scene.grains.walls.motion[index(Face::z_max)] = LoadedWall{1000, 2600 * 0.5};
  scene.fluid.emplace();
  scene.fluid->fluid.viscosity = viscosity;
  scene.fluid->faces[index(Face::z_min)] = scene.fluid->faces[index(Face::z_max)] = Pressure{0};
  return scene;
}

} // namespace pfv
