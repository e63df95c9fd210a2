#include "support/packing_files.hpp"

#include <gtest/gtest.h>

namespace pfv {
namespace {

using testing::complaint_of;
using testing::format_sample;
using testing::read_text_as;

const std::string header = "a title\n\n1 atoms\n1 atom types\n0 1 xlo xhi\n0 1 ylo yhi\n-1 1 zlo zhi # m\n\n";

std::string complaint(const std::string& text) {
  return complaint_of("p.data", text);
}

TEST(LammpsData, AtomsWithTheirBoxAsLiggghtsWritesThem) {
  const auto [packing, notes] = read_packing_file(format_sample("liggghts.data"), {}, {});
  EXPECT_EQ(packing.box, (Box{Vec3(0, 0, 0), Vec3(1, 1, 2)}));
  EXPECT_EQ(packing.spheres, (std::vector<Sphere>{{Vec3(.3, .4, .5), .2}, {Vec3(.7, .6, 1.5), .1}}));
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_TRUE(notes[0].ends_with("read as id type diameter density x y z, those of sphere and granular")) << notes[0];
}

TEST(LammpsData, ANamedStyleNeedsNoNote) {
  const auto [packing, notes] = read_text_as("p.data", header + "Atoms # sphere\n\n7 1 .25 1 .5 .25 .75 # one\n");
  EXPECT_EQ(packing.spheres, (std::vector<Sphere>{{Vec3(.5, .25, .75), .125}}));
  EXPECT_EQ(packing.box, (Box{Vec3(0, 0, -1), Vec3(1, 1, 1)}));
  EXPECT_TRUE(notes.empty());
}

TEST(LammpsData, RefusesWhatItCannotRead) {
  EXPECT_EQ(complaint(header + "Atoms # full\n\n1 1 1 0 .5 .5 .5\n"),
            "p.data:9: atom style \"full\" must be sphere or granular: others have no diameters");
  EXPECT_EQ(complaint(header + "Atoms # sphere\n\n1 1 .2 1 .5 .5\n"),
            "p.data:11: \"1 1 .2 1 .5 .5\" has 6 columns and must have 7, id type diameter density x y z, or 10");
  EXPECT_EQ(complaint(header + "Atoms # sphere\n"), "p.data:9: the file ends before 1 atoms, after 0");
  EXPECT_EQ(complaint(header), "p.data:8: the file ends before its section Atoms");
  EXPECT_EQ(complaint("\n0 1 xlo xhi\n1 atoms\nAtoms\n\n1 1 .2 1 .5 .5 .5\n"),
            "p.data:4: the section Atoms must follow the number of atoms and xlo xhi, ylo yhi, zlo zhi");
  EXPECT_EQ(complaint("\n0 1 xlo xhi\n0 0 0 xy xz yz\n"),
            "p.data:3: box \"0 0 0 xy xz yz\" must be orthogonal, without xy xz yz");
  EXPECT_EQ(complaint("\n0 1 xlo xhi\n1.5 atoms\n"),
            "p.data:3: number of atoms \"1.5\" must be a whole number, at most 1e9");
}

} // namespace
} // namespace pfv
