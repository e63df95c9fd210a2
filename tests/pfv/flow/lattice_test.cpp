// The model's closed form on lattices: k = n S_f R_h^2 / (2 l) of one throat. Data: tests/data/pfv_lattice.csv.
#include "pfv/problem/generate.hpp"
#include "support/packings.hpp"

#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <sstream>

using namespace pfv;
using pfv::testing::flow_through;
using pfv::testing::solved;

namespace {

const std::map<std::string, Lattice> lattices{
    {"sc", Lattice::simple_cubic}, {"bcc", Lattice::bcc}, {"fcc", Lattice::fcc}};

struct Row {
  std::string lattice;
  double solid_fraction;
  std::optional<double> k_over_d2, k_over_stokes;
};

std::vector<Row> closed_forms() {
  std::ifstream file(TEST_DATA "/pfv_lattice.csv");
  std::vector<Row> rows;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('#') || line.starts_with("lattice"))
      continue;
    std::istringstream fields(line);
    std::string name, phi, k, ratio;
    std::getline(fields, name, ',');
    std::getline(fields, phi, ',');
    std::getline(fields, k, ',');
    std::getline(fields, ratio, ',');
    const auto number = [](const std::string& s) { return s.empty() ? std::nullopt : std::optional(std::stod(s)); };
    rows.push_back({name, std::stod(phi), number(k), number(ratio)});
  }
  return rows;
}

double k_over_d2(Lattice lattice, double solid_fraction, int cells, Axis axis) {
  const auto packing = lattice_packing(lattice, solid_fraction, cells);
  const auto flow = solved(flow_through(packing, axis));
  const double d = 2 * packing.spheres.front().radius;
  return *flow.permeability / (d * d);
}

TEST(Lattice, TouchingGivesTheClosedFormWhateverTheNumberOfLayersAndTheAxis) {
  int compared = 0;
  for (const auto& row : closed_forms()) {
    if (!row.k_over_d2)
      continue;
    const Lattice lattice = lattices.at(row.lattice);
    for (const int cells : {1, 2, 3, 5})
      for (const Axis axis : {Axis::x, Axis::y, Axis::z})
        EXPECT_NEAR(k_over_d2(lattice, touching_solid_fraction(lattice), cells, axis) / *row.k_over_d2, 1, 1e-5)
            << row.lattice << ' ' << cells;
    ++compared;
  }
  EXPECT_EQ(compared, 3);
}

/// Drag coefficients K of the same lattices (k = d^2 / (18 phi K)): tests/data/README.md.
double stokes_k_over_d2(const std::string& lattice, double phi) {
  static const std::map<std::pair<std::string, double>, double> drag{
      {{"sc", .45}, 28.0864},   {{"bcc", .45}, 31.6882},  {{"fcc", .45}, 33.4898},  {{"sc", .343}, 15.3995},
      {{"bcc", .343}, 16.3350}, {{"fcc", .343}, 16.6390}, {{"sc", .216}, 7.44195},  {{"bcc", .216}, 7.73878},
      {{"fcc", .216}, 7.75768}, {{"sc", .125}, 4.29159},  {{"bcc", .125}, 4.44638}, {{"fcc", .125}, 4.44572}};
  return 1 / (18 * phi * drag.at({lattice, phi}));
}

TEST(Lattice, LooseGivesTheClosedForm) {
  int compared = 0;
  for (const auto& row : closed_forms()) {
    if (row.k_over_d2)
      continue;
    const double k = k_over_d2(lattices.at(row.lattice), row.solid_fraction, 1, Axis::z);
    // The file gives the ratio to two decimals.
    EXPECT_NEAR(k / stokes_k_over_d2(row.lattice, row.solid_fraction), *row.k_over_stokes, 0.0051) << row.lattice;
    ++compared;
  }
  EXPECT_EQ(compared, 12);
}

TEST(Lattice, ForcePerSphereIsTheGradientTimesItsCell) {
  for (const auto& [name, lattice] : lattices) {
    const auto packing = lattice_packing(lattice, touching_solid_fraction(lattice), 4);
    const auto flow = solved(flow_through(packing));
    const int per_cell = lattice == Lattice::simple_cubic ? 1 : lattice == Lattice::bcc ? 2 : 4;
    const double expected = -1.0 / 4 * (1.0 / per_cell); // |grad p| V_cell, down the pressure
    int inner = 0;
    for (std::size_t k = 0; k < packing.spheres.size(); ++k) {
      const Vec3& at = packing.spheres[k].centre;
      if ((at.array() < 1).any() || (at.array() > 3).any())
        continue;
      EXPECT_NEAR(flow.forces.of_flow(k).z(), expected, 1e-12) << name;
      EXPECT_NEAR(flow.forces.of_flow(k).x(), 0, 1e-12);
      ++inner;
    }
    EXPECT_GE(inner, 8);
  }
}

TEST(Lattice, JitterChangesThePermeabilityNoMoreThanItself) {
  for (const auto& [name, lattice] : lattices)
    for (const double share : {0.99, 1.0}) { // just not touching, and touching
      const Packing exact = lattice_packing(lattice, share * touching_solid_fraction(lattice), 3);
      const double k = *solved(flow_through(exact)).permeability;
      for (const double jitter : {1e-15, 1e-14, 1e-13, 3e-13, 1e-12, 3e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-6})
        EXPECT_NEAR(*solved(flow_through(jittered(exact, jitter))).permeability / k, 1, 1e-9 + 20 * jitter)
            << name << ' ' << share << ' ' << jitter;
    }
}

} // namespace
