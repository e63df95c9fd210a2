#include "support/packing_files.hpp"

#include <gtest/gtest.h>

namespace pfv {
namespace {

using testing::complaint_of;
using testing::format_sample;
using testing::read_text_as;

const Box unit_box;
const std::vector<Sphere> exported{
    {Vec3(0.25, 0.5, 0.75), 0.2}, {Vec3(0.75, 0.25, 0.25), 0.125}, {Vec3(0.1, 0.1, 0.1), 0.0625}};

std::string complaint(std::string_view text) {
  return complaint_of("p.txt", text, {.box = unit_box});
}

TEST(YadeExport, AllItsFormatsAreRead) {
  for (const char* name : {"yade_text.txt", "yade_mat_id.txt", "yade_id.txt", "yade_attrs.txt"}) {
    const auto [packing, notes] = read_packing_file(format_sample(name), {.box = unit_box});
    EXPECT_EQ(packing, (Packing{unit_box, exported})) << name;
    EXPECT_TRUE(notes.empty());
  }
}

TEST(YadeExport, MayHaveABoxAndCommentsBeforeItsFormat) {
  EXPECT_EQ(read_text_as("p.txt", "# by hand\n\n# box 0 0 0 1 1 1\n#format x_y_z_r_clumpId\n.5 .5 .5 .25 7\n").packing,
            (Packing{unit_box, {{Vec3(.5, .5, .5), .25}}}));
}

TEST(YadeExportRefuses, FormatsWithoutSpheres) {
  EXPECT_EQ(complaint("#format jointedPM\n0 1 2\n"),
            "p.txt:1: \"#format jointedPM\" must name columns x, y, z and r, as #format x_y_z_r_matId does");
  EXPECT_EQ(complaint("#format\n0 1 2 3\n"),
            "p.txt:1: \"#format\" must name columns x, y, z and r, as #format x_y_z_r_matId does");
  EXPECT_EQ(complaint("#format x_y_z_r\n#format x_y_z_r\n"), "p.txt:2: second \"#format\" line; only one is allowed");
}

TEST(YadeExportRefuses, RowsThatAreNotOfTheFormat) {
  EXPECT_EQ(complaint("#format x_y_z_r_matId\n.5 .5 .5 .1\n"),
            "p.txt:2: \".5 .5 .5 .1\" has 4 columns and must have 5 as #format x_y_z_r_matId says");
  EXPECT_EQ(complaint("#format x_y_z_r_attrs\n.5 .5 .5\n"),
            "p.txt:2: \".5 .5 .5\" has 3 columns and must have 4 or more as #format x_y_z_r_attrs says");
  EXPECT_EQ(complaint("#format x_y_z_r\n# \n.5 .5 5,0 .1\n"), "p.txt:3: z \"5,0\" must be a number (m)");
  EXPECT_EQ(complaint("#format x_y_z_r\n.5 .5 .5 -.1\n"), "p.txt:2: radius \"-0.1\" must be a positive number (m)");
}

} // namespace
} // namespace pfv
