#include "support/packing_files.hpp"

#include <gtest/gtest.h>

namespace pfv {
namespace {

using testing::complaint_of;
using testing::format_sample;
using testing::read_text_as;

constexpr PeriodicAxes along_y{false, true, false};

/// A snapshot of one atom in the unit box.
std::string snapshot(const std::string& columns, const std::string& atom, const std::string& flags = "ff ff ff",
                     const std::string& count = "1") {
  return "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n" + count + "\nITEM: BOX BOUNDS " + flags +
         "\n0 1\n0 1\n0 1\nITEM: ATOMS " + columns + "\n" + atom + "\n";
}

Sphere only_sphere(const std::string& text) {
  return read_text_as("p.dump", text).packing.spheres.at(0);
}

std::string complaint(const std::string& text) {
  return complaint_of("p.dump", text);
}

TEST(LammpsDump, LastSnapshotWithItsBox) {
  const auto [packing, notes] = read_packing_file(format_sample("liggghts.dump"), {}, along_y);
  EXPECT_EQ(packing.box, (Box{Vec3(0, -.5, 0), Vec3(1, 1.5, 2)}));
  EXPECT_EQ(packing.spheres,
            (std::vector<Sphere>{{Vec3(.52, 1.25, .5), .25}, {Vec3(.27, .5, .75), .2}, {Vec3(.77, .25, 1.25), .125}}));
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_TRUE(notes[0].ends_with("liggghts.dump: the last of 3 snapshots, time step 20")) << notes[0];
}

TEST(LammpsDump, ScaledPositionsAndDiametersAreTheSame) {
  EXPECT_EQ(read_packing(format_sample("liggghts_scaled.dump")), read_packing(format_sample("liggghts.dump")));
}

TEST(LammpsDump, ColumnsInAnyOrderAndOfAnyKind) {
  const Sphere sphere{Vec3(.5, .25, .75), .125};
  EXPECT_EQ(only_sphere(snapshot("radius z id y x", ".125 .75 1 .25 .5")), sphere);
  EXPECT_EQ(only_sphere(snapshot("xu ysu zs diameter", ".5 .25 .75 .25")), sphere);
  EXPECT_EQ(only_sphere(snapshot("xs x y z diameter radius", "9 .5 .25 .75 9 .125")), sphere); // x before xs
}

TEST(LammpsDump, AtomsAreWrappedIntoAPeriodicBoxOnly) {
  EXPECT_EQ(only_sphere(snapshot("xu yu zu radius", "2.5 -.75 .75 .125", "pp pp pp")),
            (Sphere{Vec3(.5, .25, .75), .125}));
  EXPECT_EQ(only_sphere(snapshot("xsu ysu zsu radius", "-.5 3.25 .75 .125", "pp pp pp")),
            (Sphere{Vec3(.5, .25, .75), .125}));
  EXPECT_EQ(complaint(snapshot("x y z radius", "1.5 .5 .5 .1")),
            "p.dump:10: centre \"1.5 0.5 0.5\" must lie in the box \"0 0 0 1 1 1\" (m)");
}

TEST(LammpsDump, SaysWhenItsBoxRepeatsAndTheQuestionsDoesNot) {
  const std::string text = snapshot("x y z radius", ".5 .5 .5 .1", "pp ff pp");
  const auto notes = read_text_as("p.dump", text).notes;
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_TRUE(notes[0].ends_with("p.dump: its box repeats along x, z, that of the question along no axis")) << notes[0];
  EXPECT_TRUE(read_text_as("p.dump", text, {}, {true, false, true}).notes.empty());
}

TEST(LammpsDump, KnowsUnitsAndTime) {
  EXPECT_EQ(only_sphere("ITEM: UNITS\nsi\nITEM: TIME\n0.5\n" + snapshot("x y z radius", ".5 .5 .5 .1")),
            (Sphere{Vec3(.5, .5, .5), .1}));
}

TEST(LammpsDumpRefuses, WhatItIsNotFor) {
  EXPECT_EQ(complaint(snapshot("x y z radius", ".5 .5 .5 .1", "xy xz yz pp pp pp")),
            "p.dump:5: box \"xy xz yz pp pp pp\" must be orthogonal, as three pairs of p, f, s and m (pp ff ff) say");
  EXPECT_EQ(
      complaint("ITEM: TIMESTEP\n0\nITEM: NUMBER OF ENTRIES\n1\n"),
      "p.dump:3: \"ITEM: NUMBER OF ENTRIES\" must be ITEM: and TIMESTEP, NUMBER OF ATOMS, BOX BOUNDS, ATOMS, UNITS "
      "or TIME");
  EXPECT_EQ(complaint(snapshot("id type x y z", "1 1 .5 .5 .5")),
            "p.dump:9: columns \"id type x y z\" must have x, y, z (or xu, xs, xsu ...) and radius or diameter");
  EXPECT_EQ(complaint(snapshot("x y radius", ".5 .5 .1")),
            "p.dump:9: columns \"x y radius\" must have x, y, z (or xu, xs, xsu ...) and radius or diameter");
}

TEST(LammpsDumpRefuses, BadValues) {
  EXPECT_EQ(complaint(snapshot("x y z radius", ".5 .5 up .1")), "p.dump:10: z \"up\" must be a number (m)");
  EXPECT_EQ(complaint(snapshot("x y z diameter", ".5 .5 .5 wide")),
            "p.dump:10: diameter \"wide\" must be a number (m)");
  EXPECT_EQ(complaint(snapshot("x y z radius", ".5 .5 .5 .1", "ff ff ff", "-3")),
            "p.dump:4: number of atoms \"-3\" must be a whole number, at most 1e9");
  EXPECT_EQ(complaint(snapshot("x y z radius", ".5 .5 .5")),
            "p.dump:10: \".5 .5 .5\" has 3 columns and must have 4, as ITEM: ATOMS says");
  EXPECT_EQ(complaint("ITEM: TIMESTEP\n0\nITEM: BOX BOUNDS ff ff ff\n0 1 2\n"),
            "p.dump:4: bounds \"0 1 2\" must be two numbers, lower and upper");
  EXPECT_EQ(complaint("ITEM: TIMESTEP\n0\nITEM: BOX BOUNDS ff ff ff\n0 one\n"),
            "p.dump:4: upper bound \"one\" must be a number (m)");
  EXPECT_EQ(complaint(snapshot("x y z radius", ".5 .5 .5 .1", "ff ff ff", "0")),
            "p.dump:10: \".5 .5 .5 .1\" must be ITEM: and TIMESTEP, NUMBER OF ATOMS, BOX BOUNDS, ATOMS, UNITS or TIME");
}

TEST(LammpsDumpRefuses, WhatIsCutOff) {
  EXPECT_EQ(complaint(snapshot("x y z radius", ".5 .5 .5 .1", "ff ff ff", "3")),
            "p.dump:10: the dump ends before 3 atoms, after 1");
  EXPECT_EQ(complaint("ITEM: TIMESTEP\n"), "p.dump:1: the dump ends before the time step");
  EXPECT_EQ(complaint(snapshot("x y z radius", ".5 .5 .5 .1") + "ITEM: TIMESTEP\n1\nITEM: NUMBER OF ATOMS\n1\n"),
            "p.dump:14: the dump ends within a snapshot, before its ITEM: ATOMS");
  EXPECT_EQ(complaint("ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ff ff ff\n0 1\n"),
            "p.dump:6: the dump ends before the three bounds of its box");
  EXPECT_EQ(complaint("ITEM: TIMESTEP\n0\nITEM: ATOMS x y z radius\n"),
            "p.dump:3: ITEM: ATOMS must follow ITEM: NUMBER OF ATOMS and ITEM: BOX BOUNDS");
}

} // namespace
} // namespace pfv
