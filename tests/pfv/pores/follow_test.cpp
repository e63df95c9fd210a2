// A network that follows its spheres against one built anew.
#include "pfv/pores/pore_network.hpp"
#include "pfv/problem/generate.hpp"

#include <cstdlib>
#include <gtest/gtest.h>
#include <new>

using namespace pfv;

namespace {

std::size_t allocations = 0;

Packing swollen(const Packing& packing, double by) { // a motion that keeps the topology
  Packing result = packing;
  result.box.upper *= by;
  for (auto& sphere : result.spheres)
    sphere = {sphere.centre * by, sphere.radius * by};
  return result;
}

} // namespace

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size))
    return memory;
  throw std::bad_alloc();
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { // of std::stable_sort
  ++allocations;
  return std::malloc(size);
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace {

TEST(Follow, GivesTheNetworkOfTheMovedSpheres) {
  for (const PeriodicAxes periodic :
       {PeriodicAxes{}, PeriodicAxes{true, false, true}, PeriodicAxes{true, true, true}}) {
    const Packing packing = random_packing({.spheres = 200, .solid_fraction = .45, .radius_ratio = 2, .seed = 2});
    const Packing moved = swollen(packing, 2);
    Clock clock;
    PoreNetwork network = build_pore_network(packing, periodic, clock);
    follow(network, moved, clock);
    const PoreNetwork anew = build_pore_network(moved, periodic, clock);
    ASSERT_EQ(network.throats.pores, anew.throats.pores);
    EXPECT_NEAR(network.porosity(), anew.porosity(), 1e-12);
    for (std::size_t t = 0; t < anew.throats.size(); ++t) {
      EXPECT_NEAR(network.throats.void_volume[t], anew.throats.void_volume[t], 1e-11);
      EXPECT_NEAR(network.throats.length[t], anew.throats.length[t], 1e-12);
    }
    EXPECT_EQ(network.inverted_throats, 0u);
  }
}

TEST(Follow, AllocatesNothingAndTimesOneStage) {
  const Packing packing = random_packing({.spheres = 200, .solid_fraction = .45, .radius_ratio = 2, .seed = 2});
  Clock clock;
  PoreNetwork network = build_pore_network(packing, {}, clock);
  follow(network, packing, clock);
  const std::size_t before = allocations;
  follow(network, packing, clock);
  EXPECT_EQ(allocations - before, 0u);
  EXPECT_EQ(clock.stages().size(), 3u); // cells, triangulate, geometry
}

TEST(Follow, CountsThroatsTurnedInsideOut) {
  Packing packing = random_packing({.spheres = 200, .solid_fraction = .3, .radius_ratio = 2, .seed = 2});
  Clock clock;
  PoreNetwork network = build_pore_network(packing, {}, clock);
  for (std::size_t k = 0; k < packing.spheres.size(); ++k) // neighbours part ways
    packing.spheres[k].centre.x() += (k % 2 == 0 ? 1 : -1) * .5 * packing.spheres[k].radius;
  follow(network, packing, clock);
  EXPECT_GT(network.inverted_throats, 10u);
}

} // namespace
