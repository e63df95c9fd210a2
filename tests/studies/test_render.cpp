#include "pfv/flow/steady_flow.hpp"
#include "pfv/problem/error.hpp"
#include "pfv/problem/generate.hpp"
#include "reference/on_path.hpp"
#include "studies/places/cut_in_space.hpp"
#include "studies/render/render.hpp"
#include "studies/runner/colours.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace studies {
namespace {

double volume(const pfv::Box& box) {
  return box.size().prod();
}

/// A random packing with the share of its height in every pore, and in the last of them no number.
RenderScene example() {
  const auto packing = pfv::random_packing({.spheres = 15, .solid_fraction = 0.45, .radius_ratio = 2, .seed = 3});
  pfv::Clock clock;
  const auto network = pfv::build_pore_network(packing, {}, clock);
  std::vector<double> shares;
  for (const pfv::Vec3& centre : network.pores.centre)
    shares.push_back(centre.y());
  shares.back() = std::nan("");
  return cut_in_space(network, pfv::Axis::y, shares);
}

TEST(CutInSpace, LeavesThreeQuartersOfTheBoxAndColoursTheCut) {
  const RenderScene scene = example();
  ASSERT_EQ(scene.pieces.size(), 2u);
  EXPECT_DOUBLE_EQ(volume(scene.pieces[0]) + volume(scene.pieces[1]), 0.75 * volume(scene.box));
  ASSERT_EQ(scene.panels.size(), 2u);
  for (const Panel& panel : scene.panels) {
    EXPECT_EQ(panel.up, pfv::Vec3(0, 1, 0));
    EXPECT_DOUBLE_EQ(panel.across.norm(), 0.5);
    ASSERT_EQ(panel.colours.size(), static_cast<std::size_t>(panel.columns * panel.rows));
    // From the pores at the lower face, dark, to those at the upper, bright: the last row is their colour.
    const Colour bright = colour_of(1), dark = colour_of(0);
    const auto near = [](const std::array<std::uint8_t, 3>& is, const Colour& colour) {
      return std::abs(is[0] - colour.red) + std::abs(is[1] - colour.green) + std::abs(is[2] - colour.blue) < 3;
    };
    EXPECT_TRUE(near(panel.colours.front(), dark));
    EXPECT_TRUE(near(panel.colours.back(), bright));
  }
}

TEST(CutInSpace, ComesBackFromItsFile) {
  const RenderScene scene = example(), read = render_scene_from(to_json(scene));
  EXPECT_EQ(to_json(read), to_json(scene));
  EXPECT_EQ(read.spheres.size(), scene.spheres.size());
  EXPECT_EQ(read.panels[1].colours, scene.panels[1].colours);
  EXPECT_THROW(render_scene_from("{}"), pfv::InputError);
  EXPECT_THROW(render_scene_from("no scene"), pfv::InputError);
  RenderScene short_of_colours = scene;
  short_of_colours.panels[0].colours.pop_back();
  EXPECT_THROW(render_scene_from(to_json(short_of_colours)), pfv::InputError);
}

TEST(CutInSpace, IsDrawnOrSaysWhyNot) {
  const Rendering drawn = render(example());
  ASSERT_NE(drawn.png.empty(), drawn.why_not.empty());
  if (!reference::on_path("xvfb-run"))
    return;
  ASSERT_EQ(drawn.why_not, "");
  EXPECT_TRUE(drawn.png.starts_with("\x89PNG"));
  const auto byte = [&](std::size_t at) { return static_cast<int>(static_cast<unsigned char>(drawn.png.at(at))); };
  EXPECT_EQ(byte(18) * 256 + byte(19), 900); // width
  EXPECT_EQ(byte(22) * 256 + byte(23), 900); // height
}

} // namespace
} // namespace studies
