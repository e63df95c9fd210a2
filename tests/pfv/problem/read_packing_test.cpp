#include "pfv/problem/error.hpp"
#include "pfv/problem/packing.hpp"
#include "support/message_of.hpp"
#include "support/temporary_file.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>

namespace pfv {
namespace {

using testing::message_of;
using testing::TemporaryFile;

/// What read_packing says of a file with this text, without the folder.
std::string complaint(std::string_view text) {
  const TemporaryFile file("p.txt", text);
  std::string message = message_of<InputError>([&] { read_packing(file.path()); });
  const std::string folder = file.path().parent_path().string() + "/";
  if (message.starts_with(folder))
    message.erase(0, folder.size());
  return message;
}

Packing read(std::string_view text) {
  const TemporaryFile file("p.txt", text);
  return read_packing(file.path());
}

const Packing sample{{Vec3(0, -1, 0), Vec3(2, 1, 1)}, {{Vec3(0.5, 0, 0.25), 0.125}, {Vec3(1.5, -0.5, 1), 2e-3}}};

TEST(ReadPacking, Text) {
  EXPECT_EQ(read("# made by hand\n# box 0 -1 0 2 1 1\n\n0.5 0 0.25 0.125\n  1.5\t-0.5 +1.0e0 2E-3 # cut\n"), sample);
  EXPECT_EQ(read("# box 0 -1 0 2 1 1\r\n.5 0 .25 .125\r\n1.5 -.5 1. 2e-3"), sample); // no end of line at the end
  EXPECT_EQ(read(".5 0 .25 .125\n1.5 -.5 1 2e-3\n#box 0 -1 0 2 1 1\n"), sample);     // box last
}

TEST(ReadPacking, Csv) {
  EXPECT_EQ(read("# box 0 -1 0 2 1 1\nx,y,z,r\n0.5,0,0.25,0.125\n1.5,-0.5,1,0.002\n"), sample);
  EXPECT_EQ(read("\xEF\xBB\xBFradius, z ,y,x\r\n# box 0 -1 0 2 1 1\r\n0.125, 0.25,0,0.5\r\n0.002,1,-0.5 ,1.5\r\n"),
            sample);
  EXPECT_EQ(read("# box 0 -1 0 2 1 1\nx,y,z,diameter\n0.5,0,0.25,0.25\n1.5,-0.5,1,0.004\n"), sample);
  EXPECT_EQ(read("# box 0 -1 0 2 1 1\nr x y z\n0.125 0.5 0 0.25\n0.002 1.5 -0.5 1\n"), sample);
}

TEST(ReadPacking, WhatIsWrittenReadsBackTheSame) {
  Packing packing{{Vec3(-1e-3, 0.1, 0), Vec3(1 / 3.0, 1e22, 1)},
                  {{Vec3(0.1 + 0.2, 2 / 3.0 + 1e15, 5e-324), std::numeric_limits<double>::min()},
                   {Vec3(-0.0, 1e21, std::nextafter(1.0, 0.0)), 123456789.123456789}}};
  std::ostringstream text;
  write_packing(packing, text);
  EXPECT_EQ(read(text.str()), packing);
}

TEST(ReadPacking, SampleFiles) {
  const Packing packing = read_packing(std::filesystem::path(TEST_DATA) / "g200.txt");
  EXPECT_EQ(packing.spheres.size(), 200U);
  EXPECT_EQ(packing.box, Box{});
  EXPECT_NEAR(solid_fraction(packing), 0.52, 1e-12);
}

TEST(ReadPackingRefuses, BadNumbers) {
  EXPECT_EQ(complaint("# box 0 0 0 1 1 1\n\n.5 .5 .5 abc\n"), "p.txt:3: r \"abc\" must be a number (m)");
  EXPECT_EQ(complaint("# box 0 0 0 1 1 1\n.5 .5 1.2.3 .1\n"), "p.txt:2: z \"1.2.3\" must be a number (m)");
  EXPECT_EQ(complaint("# box 0 0 0 1 1 1\n.5 0x1 .5 .1\n"), "p.txt:2: y \"0x1\" must be a number (m)");
  EXPECT_EQ(complaint("# box 0 0 0 1 1 1\n+-1 .5 .5 .1\n"), "p.txt:2: x \"+-1\" must be a number (m)");
  EXPECT_EQ(complaint("# box 0 0 0 1 1 1\n1e999 .5 .5 .1\n"), "p.txt:2: x \"1e999\" must be a number (m)");
  EXPECT_EQ(complaint("# box 0 0 0 1 1 one\n.5 .5 .5 .1\n"), "p.txt:1: box \"one\" must be a number (m)");
  EXPECT_EQ(complaint("x,y,z,r\n# box 0 0 0 1 1 1\n.5,.5,,.1\n"), "p.txt:3: z \"\" must be a number (m)");
}

TEST(ReadPackingRefuses, BadValues) {
  EXPECT_EQ(complaint("# box 0 0 0 1 1 1\n.5 .5 .5 .1\n.6 .5 .5 -0.1\n"),
            "p.txt:3: radius \"-0.1\" must be a positive number (m)");
  EXPECT_EQ(complaint("# box 0 0 0 1 1 1\n.5 .5 .5 0\n"), "p.txt:2: radius \"0\" must be a positive number (m)");
  EXPECT_EQ(complaint("# box 0 0 0 1 1 1\n.5 .5 .5 nan\n"), "p.txt:2: radius \"nan\" must be a positive number (m)");
  EXPECT_EQ(complaint("# box 0 0 0 1 1 1\n.5 inf .5 .1\n"),
            "p.txt:2: centre \"0.5 inf 0.5\" must be three finite numbers (m)");
  EXPECT_EQ(complaint("# box 0 0 0 1 1 1\n.5 1.5 .5 .1\n"),
            "p.txt:2: centre \"0.5 1.5 0.5\" must lie in the box \"0 0 0 1 1 1\" (m)");
  EXPECT_EQ(complaint("\n# box 0 0 0 1 0 1\n.5 .5 .5 .1\n"),
            "p.txt:2: box \"0 0 0 1 0 1\" must be six finite numbers, the lower corner below the upper in x, y and z "
            "(m)");
}

TEST(ReadPackingRefuses, TwoSpheresAtOnePlaceNamingBothLines) {
  const std::string message = complaint("# box 0 0 0 1 1 1\n.5 .5 .5 .1\n.6 .5 .5 .1\n# \n.5 .5 .5 .1\n");
  EXPECT_TRUE(message.starts_with("p.txt:5: centre \"0.5 0.5 0.5\" must differ")) << message;
  EXPECT_TRUE(message.ends_with("p.txt:2 has it too")) << message;
}

TEST(ReadPacking, TakesTheNamedColumnsOfATableAsParaViewWritesIt) {
  const TemporaryFile file("p.csv", "\"id\",\"radius\",\"Points:0\",\"Points:1\",\"Points:2\"\n"
                                    "# box 0 0 0 1 1 1\n7,.125,.5,.25,.75\n");
  EXPECT_EQ(read_packing(file.path()).spheres, (std::vector<Sphere>{{Vec3(.5, .25, .75), .125}}));
}

TEST(ReadPackingRefuses, WrongColumns) {
  EXPECT_EQ(complaint("# box 0 0 0 1 1 1\n.5 .5 .5\n"),
            "p.txt:2: \".5 .5 .5\" has 3 columns and must have four, the numbers x y z r (m); CSV needs a first line "
            "that names them");
  EXPECT_EQ(complaint("x,y,z,r\n# box 0 0 0 1 1 1\n.5,.5,.5,.1,7\n"),
            "p.txt:3: \".5 .5 .5 .1 7\" has 5 columns and must have 4, as its first line has");
  for (const char* header : {"x,y,z", "x,y,z,d", "x,y,z,r,x", "x,y,r,radius", "hello"})
    EXPECT_EQ(complaint(std::string(header) + "\n# box 0 0 0 1 1 1\n"),
              std::string("p.txt:1: columns \"") + header +
                  "\" must be x, y, z and one of r, radius, radii, diameter, each once, in any order");
}

TEST(ReadPackingRefuses, NoBoxOrTwo) {
  EXPECT_EQ(
      complaint("# a box\n.5 .5 .5 .1\n"),
      "p.txt: no box; --box, box in [packing] or, in text, a line \"# box x0 y0 z0 x1 y1 z1\" must say it; that of the "
      "spheres is --box 0.4,0.4,0.4,0.6,0.6,0.6");
  EXPECT_EQ(complaint("# box 0 0 0 1 1\n"), "p.txt:1: \"# box 0 0 0 1 1\" must be # box x0 y0 z0 x1 y1 z1 (m)");
  EXPECT_EQ(complaint("# box 0 0 0 1 1 1\n# box 0 0 0 1 1 1\n.5 .5 .5 .1\n"),
            "p.txt:2: second \"# box\" line; only one is allowed, and line 1 is one");
}

TEST(ReadPackingRefuses, EmptyPackings) {
  EXPECT_EQ(complaint(""), "p.txt: packing has \"0\" spheres and needs at least one");
  EXPECT_EQ(complaint("\n# box 0 0 0 1 1 1\n"), "p.txt: packing has \"0\" spheres and needs at least one");
}

TEST(ReadPackingRefuses, UnreadableFiles) {
  EXPECT_EQ(message_of<InputError>([] { read_packing("/nowhere/p.txt"); }),
            "/nowhere/p.txt: cannot be read: No such file or directory");
  EXPECT_EQ(message_of<InputError>([] { read_packing("/"); }), "/: cannot be read: Is a directory");
}

} // namespace
} // namespace pfv
