#include "pfv/flow/conductance.hpp"

#include "pfv/flow/choice.hpp"
#include "pfv/problem/generate.hpp"
#include "support/message_of.hpp"
#include "support/packings.hpp"

#include <gtest/gtest.h>
#include <limits>
#include <numbers>

using namespace pfv;
using namespace pfv::testing;

namespace {

PoreNetwork network_of(const Packing& packing) {
  Clock clock;
  return build_pore_network(packing, {}, clock);
}

TEST(ConductanceRules, AreHagenPoiseuilleInATube) { // K = pi r^4 / (8 mu l)
  const double r = .3, l = 2, mu = 1e-3, pi = std::numbers::pi;
  const double area = pi * r * r, surface = 2 * pi * r * l;
  const double tube = pi * std::pow(r, 4) / (8 * mu * l);
  const ThroatShape throat{area, area * l, surface, l};
  EXPECT_NEAR(HydraulicRadius{}(throat, mu) / tube, 1, 1e-14);
  EXPECT_NEAR(MixedArea{}(throat, mu) / tube, 1, 1e-14);
  EXPECT_NEAR(Calibrated{}(throat, mu) / tube, 1, 1e-14); // tight: nothing of its facet is open
}

TEST(ConductanceRules, MixedAreaIsTheGeometricMeanOfBothAreas) {
  const double ratio = MixedArea{}({1, 8, 5, 2}, 1) / HydraulicRadius{}({1, 8, 5, 2}, 1);
  EXPECT_NEAR(ratio, 2, 1e-14); // Theta / l = 4 S_f
}

TEST(ConductanceRules, AreFoundByName) {
  EXPECT_EQ(names_of<Conductance>(), (std::vector<std::string_view>{"hydraulic-radius", "mixed-area", "calibrated"}));
  EXPECT_EQ(name_of(choice_named<Conductance>("conductance", "mixed-area")), "mixed-area");
  EXPECT_EQ(message_of<InputError>([] { choice_named<Conductance>("conductance", "bruggeman"); }),
            "conductance \"bruggeman\" is not one of hydraulic-radius, mixed-area, calibrated");
  EXPECT_EQ(message_of<InputError>([] { choice_named<WallRule>("walls", "rough"); }),
            "walls \"rough\" is not one of mirror, no-slip, original");
}

TEST(WallRules, LeaveInteriorThroatsAloneAndOrderTheOthers) {
  const PoreNetwork network = network_of(packing_from("g200.txt"));
  const auto by = [&](const WallRule& walls) { return conductances(network, HydraulicRadius{}, walls, 1).values; };
  const auto mirror = by(MirrorWalls{}), no_slip = by(NoSlipWalls{}), original = by(OriginalWalls{});
  std::size_t slower = 0;
  for (std::size_t t = 0; t < mirror.size(); ++t) {
    if (t < network.throats.interior) {
      EXPECT_EQ(mirror[t], no_slip[t]);
      EXPECT_EQ(mirror[t], original[t]);
      continue;
    }
    const auto walls = std::ranges::count_if(network.corners(t), is_wall);
    const bool follows_the_rule = network.throats.void_volume[t] > 0 && network.throats.fluid_area[t] > 0;
    const double factor = std::pow(2, -0.5 * static_cast<double>(walls));
    EXPECT_TRUE(!follows_the_rule || std::abs(original[t] / mirror[t] - factor) < 1e-14);
    slower += no_slip[t] < mirror[t];
  }
  EXPECT_GT(slower, 0.9 * static_cast<double>(mirror.size() - network.throats.interior));
}

TEST(Conductances, AreZeroWhereClosedAndCountRoundTubes) {
  PoreNetwork network = network_of(packing_from("g200.txt"));
  const auto before = conductances(network, HydraulicRadius{}, MirrorWalls{}, 1);
  network.throats.fluid_area[3] = 0;
  network.throats.void_volume[5] = -1e-3;
  network.throats.length[7] = 0;
  const auto after = conductances(network, HydraulicRadius{}, MirrorWalls{}, 1);
  EXPECT_EQ(after.rounded, before.rounded + 1);
  EXPECT_EQ(after.values[3], 0);
  EXPECT_NEAR(after.values[5],
              std::pow(network.throats.fluid_area[5], 2) / (8 * std::numbers::pi * network.throats.length[5]), 1e-20);
  EXPECT_EQ(after.values[7], std::numeric_limits<double>::infinity());
}

TEST(Conductances, UpdateInPlace) {
  const PoreNetwork network = network_of(packing_from("g200.txt"));
  Conductances updated = conductances(network, HydraulicRadius{}, OriginalWalls{}, 1);
  const double* values = updated.values.data();
  update(updated, network, MixedArea{}, MirrorWalls{}, 2);
  const Conductances fresh = conductances(network, MixedArea{}, MirrorWalls{}, 2);
  EXPECT_EQ(updated.values, fresh.values);
  EXPECT_EQ(updated.median, fresh.median);
  EXPECT_EQ(updated.values.data(), values);
}

} // namespace
