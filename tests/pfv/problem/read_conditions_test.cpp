#include "pfv/problem/case.hpp"
#include "pfv/problem/error.hpp"
#include "pfv/problem/generate.hpp"
#include "support/message_of.hpp"
#include "support/temporary_file.hpp"

#include <gtest/gtest.h>

namespace pfv {
namespace {

using testing::message_of;
using testing::TemporaryFile;

constexpr PeriodicAxes everywhere{true, true, true};
const std::string nine = "[packing]\ngenerator = \"nine_spheres\"\n";

Case read(const std::string& text, const QuestionOptions& options = {}) {
  const TemporaryFile file("c.toml", text);
  return read_question(file.path(), options);
}

std::string complaint(const std::string& text, const QuestionOptions& options = {}) {
  const TemporaryFile file("c.toml", text);
  std::string message = message_of<InputError>([&] { read_question(file.path(), options); });
  const std::string folder = file.path().parent_path().string() + "/";
  return message.starts_with(folder) ? message.substr(folder.size()) : message;
}

TEST(ReadConditions, EveryKindAndBackAgain) {
  const Case problem = read(nine + R"(
    [faces]
    x_min = "periodic"
    x_max = { periodic = 0 }
    y_min = "slip"
    y_max = { flux = -2e-6 }
    z_min = { pressure = 3 }
    z_max = { pressure = [[0, 1], [0.5, 2.5]], along = "y" }
    [[pressure_points]]
    position = [0.5, 0.25, 1]
    pressure = -4
    [[pressure_points]]
    position = [0.5, 0.75, 1]
    pressure = 1
    [pfv]
    walls = "no-slip"
  )");
  const FaceConditions expected{Periodic{},  Periodic{},  SlipWall{},
                                Flux{-2e-6}, Pressure{3}, PressureProfile{Axis::y, {{0, 1}, {0.5, 2.5}}}};
  EXPECT_EQ(problem.faces, expected);
  EXPECT_EQ(problem.pressure_points, (std::vector<PressurePoint>{{Vec3(0.5, 0.25, 1), -4}, {Vec3(0.5, 0.75, 1), 1}}));
  EXPECT_EQ(read(to_toml(problem)), problem);
}

TEST(ReadConditions, OnePlaceSaysWhatIsPeriodic) {
  const std::string fcc = "[packing]\ngenerator = \"fcc\"\nsolid_fraction = 0.5\ncells = 2\n";
  const Case along = read(fcc + "[flow]\naxis = \"z\"\npressure_drop = 3\nperiodic = [\"x\", \"y\", \"z\"]\n");
  EXPECT_EQ(along.packing, lattice_packing(Lattice::fcc, 0.5, 2, 1, everywhere));
  EXPECT_EQ(along.faces, flow_along(Axis::z, 3, everywhere, along.packing.box));
  const Case faces = read(fcc + "[faces]\nx_min = \"periodic\"\nx_max = \"periodic\"\nz_min = { pressure = 1 }\n");
  EXPECT_EQ(faces.packing, lattice_packing(Lattice::fcc, 0.5, 2, 1, {true, false, false}));
  const Case random = read("[packing]\ngenerator = \"random\"\nsolid_fraction = 0.3\n[flow]\naxis = \"x\"\n"
                           "periodic = [\"x\", \"y\", \"z\"]\n");
  RandomPacking asked{30, 0.3};
  asked.periodic = everywhere;
  EXPECT_EQ(random.packing, random_packing(asked));
}

TEST(ReadConditions, SpheresOnOppositeFacesAreOne) {
  const std::string box = "[packing]\nbox = [[0, 0, 0], [1, 1, 1]]\nspheres = [\n[0, 0.5, 0.5, 0.1],\n"
                          "[1, 0.5, 0.5, 0.1]]\n[flow]\naxis = \"z\"\n";
  EXPECT_EQ(complaint(box), "no error");
  const std::string twice = complaint(box + "periodic = [\"x\"]\n");
  EXPECT_TRUE(twice.starts_with("c.toml:5: centre \"1 0.5 0.5\" must differ from that of every other sphere; "))
      << twice;
  EXPECT_TRUE(twice.ends_with("c.toml:4 has its periodic image 0 0.5 0.5")) << twice;
}

TEST(ReadConditionsRefuses, BadValuesAtTheirLine) {
  const auto face = [](const std::string& text) { return complaint(nine + "[faces]\nz_max = " + text + "\n"); };
  EXPECT_EQ(face("{ flux = \"1\" }"), "c.toml:4: flux \"1\" must be a number");
  EXPECT_EQ(face("{ flux = 1, pressure = 1 }"),
            "c.toml:4: unknown key \"pressure\" in z_max with a flux; valid keys: flux");
  EXPECT_EQ(face("{ periodic = \"x\" }"), "c.toml:4: periodic \"x\" must be a number");
  EXPECT_EQ(face("{ pressure = [[0, 1]] }"), "c.toml:4: z_max has no \"along\"; it is needed");
  EXPECT_EQ(face("{ pressure = [[0, 1]], along = \"w\" }"), "c.toml:4: axis \"w\" must be one of x, y, z");
  EXPECT_EQ(face("{ pressure = [[0, 1]], along = \"time\" }"),
            "c.toml:4: z_max pressure along \"time\" is for scenes of pfv run: the flow of a case is steady");
  EXPECT_EQ(face("{ pressure = [1], along = \"x\" }"),
            "c.toml:4: pressure \"1\" must be two numbers [position (m), pressure (Pa)]");
  EXPECT_EQ(face("{ pressure = [[1, 0], [0, 1]], along = \"x\" }"),
            "c.toml:3: z_max position \"0\" must be beyond the one before it, 1 (m)");
  EXPECT_EQ(face("\"periodic\""),
            "c.toml:3: z_min \"slip\" and z_max \"periodic 0\" must both be periodic with the same gradient (Pa/m)");
  EXPECT_EQ(complaint(nine + "[flow]\naxis = \"z\"\nperiodic = \"x\"\n"),
            "c.toml:5: periodic \"x\" must be a list of axes, [\"x\", \"y\", \"z\"] or fewer");
  EXPECT_EQ(complaint(nine + "[flow]\naxis = \"z\"\nperiodic = [\"w\"]\n"),
            "c.toml:5: axis \"w\" must be one of x, y, z");
  EXPECT_EQ(complaint(nine + "[flow]\naxis = \"z\"\n[[pressure_points]]\nposition = [2, 0, 0]\npressure = 1\n"),
            "c.toml:5: position \"2 0 0\" of a pressure point must lie in the box \"0 0 0 1 1 1\" (m)");
}

TEST(ReadQuestion, TakesABarePackingWithFlowAlongZ) {
  const TemporaryFile file("two.txt", "# box 0 0 0 1 1 2\n.5 .5 .5 .1\n.5 .5 1.5 .1\n");
  const Case plain = read_question(file.path(), {});
  EXPECT_EQ(plain.name, "two");
  EXPECT_EQ(plain.faces, flow_along(Axis::z));
  const Case turned = read_question(file.path(), {Axis::x, PeriodicAxes{false, false, true}, 3.0});
  EXPECT_EQ(turned.faces, flow_along(Axis::x, 1, {false, false, true}, plain.packing.box));
  EXPECT_EQ(turned.fluid.viscosity, 3);
  EXPECT_EQ(message_of<InputError>([&] {
              read_question(file.path(), {{}, {}, 0.0});
            }),
            "viscosity \"0\" must be a positive number (Pa s)");
}

TEST(ReadQuestion, LetsTheCommandLineWin) {
  const std::string lattice = "[packing]\ngenerator = \"bcc\"\nsolid_fraction = 0.5\n";
  const Case turned = read(lattice + "[flow]\naxis = \"z\"\npressure_drop = 5\n", {Axis::y, everywhere, {}});
  EXPECT_EQ(turned.faces, flow_along(Axis::y, 5, everywhere, turned.packing.box));
  EXPECT_EQ(turned.packing.spheres.size(), 2u) << "generated for the box as it is asked";
  const std::string faces = lattice + "[faces]\nz_max = { pressure = 1 }\n";
  EXPECT_EQ(read(faces, {Axis::y, {}, {}}).faces, flow_along(Axis::y));
  EXPECT_EQ(complaint(faces, {{}, PeriodicAxes{true, false, true}, {}}),
            "--periodic \"x,z\" needs --axis or a case with [flow]; [faces] says which are periodic");
}

} // namespace
} // namespace pfv
