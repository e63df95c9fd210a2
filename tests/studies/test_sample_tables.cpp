#include "studies/runner/sample_tables.hpp"

#include "pfv/flow/steady_flow.hpp"
#include "pfv/problem/error.hpp"
#include "pfv/problem/generate.hpp"
#include "tests/studies/example_row.hpp"
#include "tests/studies/times.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace studies {
namespace {

/// A cell under a mean gradient, and PFV's own flow through it as what was found.
struct Example {
  pfv::Case problem;
  pfv::SteadyFlow flow;
  Finding finding;

  Example() {
    const pfv::PeriodicAxes periodic{true, true, true};
    problem.packing = pfv::random_packing({.spheres = 12, .solid_fraction = 0.4, .periodic = periodic});
    problem.faces = pfv::flow_along(pfv::Axis::z, 1.0, periodic, problem.packing.box);
    pfv::Clock clock;
    flow = solve_steady_flow(problem, {}, clock);
    finding.case_id = "cell";
    finding.method = "exact";
    finding.rows = {example_row("exact", 1)};
    finding.permeability = Bounded{*flow.permeability, {}, {}};
    finding.pressure_drop = 1;
    finding.forces = BoundedField{std::vector<double>(36, 0.5), {}};
    finding.pore_pressures = BoundedField{flow.pressure, {}};
    finding.throat_fluxes.emplace();
    const auto& throats = flow.network.throats;
    for (std::size_t t = 0; t < throats.size(); ++t) {
      const auto [i, j] = throats.pores[t];
      const double rise = throats.shift[t][2] * flow.system.rise.z();
      finding.throat_fluxes->values.push_back(flow.system.conductance[t] *
                                              (flow.pressure[i] - flow.pressure[j] - rise));
    }
  }
};

TEST(SampleTables, HaveALineForEachPlace) {
  const Example example;
  SampleTables tables;
  add_samples(example.problem, example.finding, tables);
  EXPECT_EQ(times(tables.permeabilities, "\n"), 1u);
  EXPECT_EQ(times(tables.forces, "\n"), 12u);
  EXPECT_EQ(times(tables.pores, "\n"), example.flow.network.pores.size());
  EXPECT_EQ(times(tables.throats, "\n"), example.flow.network.throats.size());
  EXPECT_TRUE(tables.permeabilities.starts_with("cell,12,0.4,"));
}

TEST(SampleTables, HaveFluxesDownTheFallOfPressureAcrossTheBoxToo) {
  const Example example;
  SampleTables tables;
  add_samples(example.problem, example.finding, tables);
  std::istringstream lines(tables.throats);
  std::size_t across = 0;
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string> fields;
    std::istringstream words(line);
    for (std::string word; std::getline(words, word, ',');)
      fields.push_back(word);
    ASSERT_EQ(fields.size(), 11u);
    const auto& pressure = example.flow.pressure;
    const double rise = std::stod(fields[10]);
    const double fall = pressure[std::stoul(fields[1])] - pressure[std::stoul(fields[2])] - rise;
    EXPECT_GE(std::stod(fields[9]) * fall, 0) << line;
    across += rise != 0;
  }
  EXPECT_GT(across, 0u);
}

TEST(SampleTables, RefuseSamplesOfOtherPores) {
  Example example;
  SampleTables tables;
  example.finding.pore_pressures->values.pop_back();
  EXPECT_THROW(add_samples(example.problem, example.finding, tables), pfv::InputError);
  example.finding.pore_pressures.reset();
  EXPECT_THROW(add_samples(example.problem, example.finding, tables), pfv::InputError);
}

} // namespace
} // namespace studies
