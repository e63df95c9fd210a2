#include "studies/motion/bed.hpp"

namespace studies {

using namespace pfv;

namespace {

constexpr PeriodicAxes sideways{true, true, false};

} // namespace

GrainScene bed_grains(const Bed& bed, double local_damping) {
  GrainScene scene;
  scene.density = bed.density;
  scene.law = LinearSprings{bed.young, 0.5, {bed.friction, 0.2}};
  scene.walls.periodic = sideways;
  scene.walls.friction = bed.friction;
  scene.damping.share = local_damping;
  scene.forces = {Gravity{{0, 0, -bed.gravity}}, BuoyancyOfGrains{{bed.fluid_density, {0, 0, -bed.gravity}}}};
  if (bed.lubricated)
    scene.lubrication = Lubrication{bed.viscosity};
  return scene;
}

FluidScene bed_fluid(const Bed& bed, const FaceCondition& below) {
  FluidScene fluid;
  fluid.fluid.viscosity = bed.viscosity;
  for (const Face face : all_faces)
    if (sideways[index(axis_of(face))])
      fluid.faces[index(face)] = Periodic{};
  fluid.faces[index(Face::z_min)] = below;
  fluid.faces[index(Face::z_max)] = Pressure{0};
  return fluid;
}

double buoyant_weight(const Bed& bed, const Grains& grains) {
  double solid = 0;
  for (const Sphere& sphere : grains.packing.spheres)
    solid += volume(sphere);
  return (bed.density - bed.fluid_density) * bed.gravity * solid;
}

double lift(const Simulation& simulation) {
  double force = 0;
  for (std::size_t k = 0; k < simulation.grains().grains.size(); ++k)
    force += simulation.fluid_forces()[k].z();
  return force;
}

double on_floor(const GrainCycle& cycle) {
  return -cycle.on_wall[index(Face::z_min)];
}

double mean_height(const Grains& grains) {
  double sum = 0, mass = 0;
  for (std::size_t i = 0; i < grains.size(); ++i) {
    sum += grains.mass[i] * grains.sphere(i).centre.z();
    mass += grains.mass[i];
  }
  return sum / mass - grains.packing.box.lower.z();
}

} // namespace studies
