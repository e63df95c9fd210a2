#include "studies/motion/stability/hard_packings.hpp"

#include "pfv/problem/generate.hpp"

#include <cmath>
#include <fmt/format.h>

namespace studies {
namespace {

using namespace pfv;

/// 6^3 cells of four spheres, whole ones, moved off the walls by a quarter of a cell.
Packing fcc_864() {
  const PeriodicAxes all{true, true, true};
  Packing packing = lattice_packing(Lattice::fcc, touching_solid_fraction(Lattice::fcc), 6, 1.0 / 6, all);
  for (Sphere& sphere : packing.spheres)
    sphere.centre.array() += 0.25 / 6;
  return packing;
}

Packing random(double ratio, double fraction = 0.45, int spheres = 200) {
  return random_packing({.spheres = spheres, .solid_fraction = fraction, .radius_ratio = ratio, .seed = 4});
}

Packing grown(Packing packing, double by) {
  for (Sphere& sphere : packing.spheres)
    sphere.radius *= by;
  return packing;
}

/// A smaller box whose walls pass through spheres.
Packing cut_by_walls() {
  Packing packing = random(3);
  packing.box = {Vec3::Constant(0.11), Vec3::Constant(0.87)};
  std::erase_if(packing.spheres, [&](const Sphere& sphere) {
    return (sphere.centre.array() < packing.box.lower.array()).any() ||
           (sphere.centre.array() > packing.box.upper.array()).any();
  });
  return packing;
}

/// The first sphere reaches out of the box by this share of its radius.
Packing poking(double share) {
  Packing packing = random(1.35, 0.45, 60);
  Sphere& sphere = packing.spheres.front();
  sphere.centre.x() = (1 - share) * sphere.radius;
  return packing;
}

/// Eight spheres that overlap so far that the void between them is closed: for all, or in the middle of a random
/// packing.
Packing sealed() {
  return grown(lattice_packing(Lattice::simple_cubic, touching_solid_fraction(Lattice::simple_cubic), 3), 1.5);
}
Packing cage() {
  Packing packing = random(2);
  const double side = 0.3, radius = 0.75 * side;
  std::erase_if(packing.spheres, [&](const Sphere& sphere) {
    return (sphere.centre - Vec3::Constant(0.5)).lpNorm<Eigen::Infinity>() < 0.5 * side + radius;
  });
  for (int corner = 0; corner < 8; ++corner)
    packing.spheres.push_back(
        {Vec3::Constant(0.5 - 0.5 * side) + side * Vec3(corner & 1, corner >> 1 & 1, corner >> 2), radius});
  return packing;
}

Packing layer() {
  Packing packing{{{0, 0, 0}, {5, 5, 1}}, {}};
  for (int x = 0; x < 5; ++x)
    for (int y = 0; y < 5; ++y)
      packing.spheres.push_back({{x + 0.5, y + 0.5, 0.5}, 0.5});
  return packing;
}

Packing with_hidden() {
  return {{}, {{{.5, .5, .5}, .4}, {{.55, .5, .5}, .05}, {{.2, .2, .2}, .1}, {{.8, .2, .8}, .1}}};
}

/// Spheres with and without others inside of them.
Packing many_hidden() {
  Packing packing = random(1.35, 0.5, 100);
  for (std::size_t k = 0; k < 30; ++k) {
    const Sphere outer = packing.spheres[k];
    packing.spheres.push_back(
        {outer.centre + 0.2 * outer.radius * Vec3(std::sin(k), std::cos(k), 0.5), 0.3 * outer.radius});
  }
  return packing;
}

/// Two layers of n^2 spheres, with more than n^2 pores on each of the walls at a pressure.
Packing wide(int n) {
  Packing packing{{{0, 0, 0}, {double(n), double(n), 2}}, {}};
  for (int x = 0; x < n; ++x)
    for (int y = 0; y < n; ++y)
      for (int z = 0; z < 2; ++z)
        packing.spheres.push_back({{x + .5 + .1 * std::sin(7. * x + 3 * y), y + .5 + .1 * std::sin(5. * y + x + z),
                                    z + .5 + .05 * std::sin(11. * x * y)},
                                   .35});
  return packing;
}

} // namespace

std::vector<HardPacking> hard_packings() {
  const auto touching = [](Lattice lattice) { return lattice_packing(lattice, touching_solid_fraction(lattice), 3); };
  std::vector<HardPacking> list{{"FCC, 864 spheres", fcc_864(), true},
                                {"simple cubic, touching", touching(Lattice::simple_cubic), true},
                                {"BCC, touching, cut by walls", touching(Lattice::bcc), true},
                                {"FCC, touching, cut by walls", touching(Lattice::fcc)},
                                {"nine spheres (BCC)", nine_spheres(), true},
                                {"size ratio 5", random(5), true},
                                {"size ratio 20", random(20, 0.45, 300)},
                                {"size ratio 20, loose", random(20, 0.3, 300)}};
  for (const double overlap : {0.02, 0.05, 0.1})
    list.push_back(
        {fmt::format("radii grown by {:g} %", 100 * overlap), grown(random(1.35, 0.5), 1 + overlap), overlap == 0.1});
  list.push_back({"a sphere out by half of its radius", poking(0.5), true});
  list.push_back({"a sphere out by 1e-9 of its radius", poking(1e-9)});
  list.push_back({"spheres cut by walls", cut_by_walls()});
  list.push_back({"a hidden sphere", with_hidden(), true});
  list.push_back({"30 hidden spheres", many_hidden()});
  list.push_back({"a cage with a closed void", cage()});
  list.push_back({"all throats closed", sealed(), true, 0});
  list.push_back({"one sphere", {{}, {{{.4, .5, .6}, .3}}}, true});
  list.push_back({"two spheres", {{}, {{{.3, .5, .5}, .2}, {{.7, .5, .5}, .2}}}, true});
  list.push_back({"one layer", layer(), true});
  list.push_back({"20 000 spheres, two layers", wide(100)});
  return list;
}

} // namespace studies
