// What is said of a packing file beside it.
#include "support/packing_files.hpp"

#include "pfv/problem/case.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <limits>

namespace pfv {
namespace {

using testing::complaint_of;
using testing::message_of;
using testing::read_text_as;
using testing::TemporaryFile;

const std::string in_millimetres = "# box 0 0 0 2 4 8\n1 2 4 0.5\n";
const Packing scaled{{Vec3::Zero(), 1e-3 * Vec3(2, 4, 8)}, {{1e-3 * Vec3(1, 2, 4), 1e-3 * 0.5}}};

TEST(ScaleAndBox, ScaleIsOfAllLengths) {
  EXPECT_EQ(read_text_as("p.txt", in_millimetres, {.scale = 1e-3}).packing, scaled);
}

TEST(ScaleAndBox, BoxIsInTheUnitOfTheFileAndWinsOverItsOwn) {
  const Box box{Vec3::Zero(), Vec3(2, 4, 8)};
  EXPECT_EQ(read_text_as("p.txt", "1 2 4 0.5\n", {.scale = 1e-3, .box = box}).packing, scaled);
  EXPECT_EQ(read_text_as("p.txt", "# box 0 0 0 9 9 9\n1 2 4 0.5\n", {.scale = 1e-3, .box = box}).packing, scaled);
}

TEST(ScaleAndBox, WithoutABoxThatOfTheSpheresIsProposedAndThenWorks) {
  const std::string text = "#format x_y_z_r\n1 2 4 0.5\n-1.5 0 0 0.25\n";
  EXPECT_EQ(
      complaint_of("p.txt", text),
      "p.txt: no box; --box, box in [packing] or, in text, a line \"# box x0 y0 z0 x1 y1 z1\" must say it; that of "
      "the spheres is --box -1.75,-0.25,-0.25,1.5,2.5,4.5");
  const Box proposed = box_named("-1.75,-0.25,-0.25,1.5,2.5,4.5");
  EXPECT_EQ(read_text_as("p.txt", text, {.box = proposed}).packing.box, proposed);
}

TEST(ScaleAndBox, SpheresThatHaveNoBoxAreSoundThemselves) {
  EXPECT_EQ(complaint_of("p.txt", "1 2 4 nan\n"), "p.txt:1: radius \"nan\" must be a positive number (m)");
  EXPECT_EQ(complaint_of("p.txt", "# nothing\n"), "p.txt: packing has \"0\" spheres and needs at least one");
}

TEST(ScaleAndBox, ErrorsOfTheBoxSayWhereItWasSaid) {
  EXPECT_EQ(
      complaint_of("p.txt", "1 2 4 .5\n", {.box = Box{Vec3::Ones(), Vec3::Zero()}}),
      "--box: box \"1 1 1 0 0 0\" must be six finite numbers, the lower corner below the upper in x, y and z (m)");
  for (const char* text : {"", "0,0,0,1,1", "0,0,0,1,1,1,1", "0,0,0,1,1,one", "0 0 0 1 1 1"})
    EXPECT_EQ(message_of<InputError>([&] { box_named(text); }),
              std::string("box \"") + text + "\" must be six numbers x0,y0,z0,x1,y1,z1");
}

TEST(ScaleAndBox, ScaleMustBePositive) {
  const std::string allowed = "\" must be a positive number, the length in m of one unit of the file";
  EXPECT_EQ(complaint_of("p.txt", in_millimetres, {.scale = 0}), "scale \"0" + allowed);
  EXPECT_EQ(complaint_of("p.txt", in_millimetres, {.scale = -1e-3}), "scale \"-0.001" + allowed);
  EXPECT_EQ(complaint_of("p.txt", in_millimetres, {.scale = std::numeric_limits<double>::infinity()}),
            "scale \"inf" + allowed);
  EXPECT_EQ(complaint_of("p.txt", in_millimetres, {.scale = 1e-200}),
            "p.txt:1: box \"0 0 0 2e-200 4e-200 8e-200\" must have a volume that a double can hold");
}

TEST(ScaleAndBox, NothingThatIsNoTextIsTakenForIt) {
  EXPECT_EQ(complaint_of("p.gz", std::string("\x1f\x8b\x08\0\0\0", 6)),
            "p.gz: neither text nor VTK: it must be one of x y z r, CSV, YADE's export, LAMMPS' dump and data, .vtp, "
            ".vtu and "
            ".vtk");
  EXPECT_EQ(
      complaint_of("p.txt", "\x1b[31m\n"),
      "p.txt:1: columns \"?[31m\" must be x, y, z and one of r, radius, radii, diameter, each once, in any order");
}

/// A case beside a packing in millimetres.
class InACase : public ::testing::Test {
protected:
  Case read(const std::string& packing, const QuestionOptions& options = {}) const {
    std::ofstream(file_.path()) << "[packing]\n" << packing << "\n[flow]\naxis = \"z\"\n";
    return read_question(file_.path(), options);
  }
  std::string complaint(const std::string& packing, const QuestionOptions& options = {}) const {
    const std::string message = message_of<InputError>([&] { read(packing, options); });
    const std::string folder = file_.path().parent_path().string() + "/";
    return message.starts_with(folder) ? message.substr(folder.size()) : message;
  }

private:
  TemporaryFile file_{"c.toml", ""};
  TemporaryFile packing_{"p.txt", "1 2 4 0.5\n"};

protected:
  const std::string file_key = "file = \"" + packing_.path().string() + "\"\n";
};

TEST_F(InACase, TheSameAreKeysOfThePacking) {
  const std::string box = "box = [[0, 0, 0], [2, 4, 8]]\n";
  EXPECT_EQ(read(file_key + "scale = 1e-3\n" + box).packing, scaled);
  QuestionOptions options;
  options.packing = {.scale = 1e-3, .box = Box{Vec3::Zero(), Vec3(2, 4, 8)}};
  EXPECT_EQ(read(file_key, options).packing, scaled);
  EXPECT_EQ(read(file_key + "scale = 7\nbox = [[0, 0, 0], [9, 9, 9]]", options).packing, scaled);
}

TEST_F(InACase, ErrorsNameTheLine) {
  EXPECT_EQ(complaint(file_key + "scale = 0"),
            "c.toml:3: scale \"0\" must be a positive number, the length in m of one unit of the file");
  EXPECT_EQ(complaint(file_key + "scale = \"mm\""), "c.toml:3: scale \"mm\" must be a number");
  EXPECT_EQ(complaint(file_key + "box = [0, 0, 0, 1, 1, 1]"),
            "c.toml:3: box \"[ 0, 0, 0, 1, 1, 1 ]\" must be two corners [[x, y, z], [x, y, z]] (m)");
  EXPECT_EQ(
      complaint(file_key + "box = [[0, 0, 0], [2, 0, 8]]"),
      "c.toml:3: box \"0 0 0 2 0 8\" must be six finite numbers, the lower corner below the upper in x, y and z (m)");
  EXPECT_EQ(complaint(file_key + "unit = 1"),
            "c.toml:3: unknown key \"unit\" in [packing] with a file; valid keys: file, scale, box");
}

TEST_F(InACase, OptionsAreForFilesOnly) {
  QuestionOptions scale, box;
  scale.packing.scale = 2;
  box.packing.box = Box{};
  EXPECT_EQ(complaint("generator = \"nine_spheres\"", scale),
            "c.toml:1: --scale is for a packing file; [packing] has none");
  EXPECT_EQ(complaint("box = [[0, 0, 0], [1, 1, 1]]\nspheres = [[0.5, 0.5, 0.5, 0.1]]", box),
            "c.toml:1: --box is for a packing file; [packing] has none");
}

} // namespace
} // namespace pfv
