#include "pfv/problem/error.hpp"
#include "pfv/simulation/read_scene.hpp"

#include "support/message_of.hpp"
#include "support/temporary_file.hpp"

#include <gtest/gtest.h>

using namespace pfv;
using namespace pfv::testing;

namespace {

constexpr const char* packing = "[packing]\ngenerator = \"random\"\nspheres = 10\nsolid_fraction = 0.3\n";

SceneFile read(const std::string& text) {
  const TemporaryFile file("scene.toml", text);
  return read_scene(file.path());
}

TEST(ReadScene, NamesNothingThatIsNotWritten) {
  const Scene scene = read(packing).scene;
  EXPECT_EQ(scene.packing.spheres.size(), 10u);
  EXPECT_FALSE(scene.fluid);
  EXPECT_TRUE(scene.grains.forces.empty());
  EXPECT_FALSE(scene.grains.cohesion);
  EXPECT_FALSE(scene.grains.lubrication);
  EXPECT_FALSE(scene.grains.growth);
  EXPECT_EQ(scene.grains.damping.share, 0);
  EXPECT_EQ(scene.grains.walls, Walls{});
}

TEST(ReadScene, ReadsAllThereIs) {
  const SceneFile file = read(std::string(packing) + R"(
[grains]
density = 2500
[contact]
law = "hertz"
young = 7e9
poisson = 0.2
friction = 0.4
damping = 0.1
[walls]
friction = 0.3
x_min = "fixed"
y_max = { velocity = -0.1 }
z_max = { stress = 5e3, mass = 2 }
[local_damping]
share = 0.3
[cohesion]
tensile_strength = 1e4
shear_strength = 2e4
[gravity]
acceleration = [0, 0, -9.81]
[buoyancy]
fluid_density = 1000
gravity = [0, 0, -9.81]
[lubrication]
roughness = 1e-3
reach = 0.1
resists = ["normal", "shear"]
[fluid]
viscosity = 10
[flow]
axis = "z"
pressure_drop = 2
[compressible_fluid]
bulk_modulus = 2e9
[run]
scheme = "semi-implicit"
until = 3
step = 1e-3
)");
  const GrainScene& grains = file.scene.grains;
  EXPECT_EQ(grains.density, 2500);
  EXPECT_EQ(grains.law, ContactLaw(HertzMindlin{7e9, 0.2, {0.4, 0.1}}));
  EXPECT_EQ(grains.walls.friction, 0.3);
  EXPECT_EQ(grains.walls.motion[index(Face::y_max)], WallMotion(MovingWall{-0.1}));
  EXPECT_EQ(grains.walls.motion[index(Face::z_max)], WallMotion(LoadedWall{5e3, 2}));
  EXPECT_EQ(grains.damping.share, 0.3);
  EXPECT_EQ(grains.cohesion, (Cohesion{1e4, 2e4}));
  EXPECT_EQ(grains.forces,
            (std::vector<BodyForce>{Gravity{Vec3(0, 0, -9.81)}, BuoyancyOfGrains{{1000, Vec3(0, 0, -9.81)}}}));
  EXPECT_EQ(grains.lubrication, (Lubrication{10, 1e-3, 0.1, {FilmMotion::normal, FilmMotion::shear}}));
  ASSERT_TRUE(file.scene.fluid);
  EXPECT_EQ(file.scene.fluid->fluid.viscosity, 10);
  EXPECT_EQ(file.scene.fluid->compressible, CompressibleFluid{2e9});
  EXPECT_TRUE(std::holds_alternative<SemiImplicit>(file.scene.scheme));
  EXPECT_EQ(file.scene.step, 1e-3);
  EXPECT_EQ(file.duration.until, 3);
}

TEST(ReadScene, HasPressuresInTimeAndSealedBoxes) {
  const auto fluid = [](const std::string& faces) { return *read(std::string(packing) + faces).scene.fluid; };
  const FluidScene ramp = fluid("[faces]\nz_min = { pressure = [[-1, 1], [3, 5]], along = \"time\" }\n");
  EXPECT_EQ(ramp.faces[index(Face::z_min)], FaceCondition(Pressure{2}));
  EXPECT_EQ(ramp.in_time[index(Face::z_min)], (PressureInTime{{{-1, 1}, {3, 5}}}));
  EXPECT_FALSE(ramp.in_time[index(Face::z_max)]);
  EXPECT_EQ(fluid("[faces]\n[compressible_fluid]\nbulk_modulus = 1e6\n").faces, FaceConditions{});
}

TEST(ReadScene, GrowsGrains) {
  const Scene scene = read(std::string(packing) + "[growth]\nrate = 0.1\nstress = 1e3\n").scene;
  EXPECT_EQ(scene.grains.growth, (Growth{0.1, 1e3}));
}

TEST(ReadScene, LubricatesWithoutAFlow) {
  const Scene scene = read(std::string(packing) + "[fluid]\nviscosity = 3\n[lubrication]\n").scene;
  EXPECT_FALSE(scene.fluid);
  EXPECT_EQ(scene.grains.lubrication, Lubrication{3});
}

TEST(ReadScene, RefusesInOneLineThatQuotesTheValue) {
  const auto message = [](const std::string& text) {
    return message_of<InputError>([&] { read(std::string(packing) + text); });
  };
  const auto says = [&](const std::string& text, const char* part) {
    const std::string line = message(text);
    EXPECT_NE(line.find(part), std::string::npos) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos) << line;
  };
  says("[contact]\nlaw = \"glue\"\n", "\"glue\" is not one of linear, constant, hertz");
  says("[contact]\nyoung = -1\n", "young \"-1\" must be above 0");
  says("[contact]\npoisson = 0.2\n", "poisson");
  says("[walls]\nz_max = \"loose\"\n", "must be \"fixed\", { velocity = m/s } or { stress = Pa, mass = kg }");
  says("[run]\nunbalanced = 0\nsteps = 9\n", "unbalanced \"0\" must be above 0");
  says("[run]\nunbalanced = 1e-4\n", "unbalanced \"0.0001\" needs steps or until: the most it may take");
  says("[flow]\naxis = \"z\"\n[run]\nunbalanced = 1e-4\nsteps = 9\n", "is for dry grains");
  says("[local_damping]\nshare = 2\n", "share \"2\" must be at least 0 and at most 0.99");
  says("[fluid]\nviscosity = 1\n", "[fluid] needs [flow] or [faces]: without them the scene is dry");
  says("[lubrication]\n", "[lubrication] needs the viscosity (Pa s) of [fluid]");
  says("[fluid]\n[flow]\naxis = \"z\"\n[lubrication]\n", "[lubrication] needs the viscosity (Pa s) of [fluid]");
  const std::string films = "[fluid]\nviscosity = 1\n[lubrication]\n";
  says(films + "reach = 1.5\n", "reach \"1.5\" must be above 0 and at most 1");
  says(films + "roughness = 0\n", "roughness \"0\" must be above 0");
  says(films + "roughness = 0.5\nreach = 0.1\n", "roughness \"0.5\" must be below reach \"0.1\"");
  says(films + "resists = []\n", "must be a list of some of normal, shear, roll, twist");
  says(films + "resists = [\"squeeze\"]\n", "resists \"squeeze\" is not one of normal, shear, roll, twist");
  says(films + "gap = 1\n", "gap");
  says("[flow]\naxis = \"z\"\n[run]\nscheme = \"magic\"\n", "\"magic\" is not one of explicit, semi-implicit");
  const std::string growth = "[growth]\nrate = 1\nstress = 9\n";
  says("[growth]\nstress = 1\n", "[growth] has no \"rate\"");
  says("[growth]\nrate = 0\nstress = 1\n", "rate \"0\" must be above 0");
  says(growth + "[flow]\naxis = \"z\"\n", "growth of radii is for dry grains");
  says(growth + films, "growth of radii is for dry grains");
  says(growth + "[walls]\nx_min = { stress = 5 }\n", "x_min at a stress of \"5\" (Pa) cannot be beside growth");
  const std::string ramp = "[faces]\nz_min = { along = \"time\", pressure = ";
  says(ramp + "[] }\n", "z_min pressure \"[]\" must be a number or at least one [time, pressure]");
  says(ramp + "[[1, 0], [1, 2]] }\n", "z_min time \"1\" must be beyond the one before it, 1 (s)");
  says(ramp + "[3] }\n", "pressure \"3\" must be two numbers [time (s), pressure (Pa)]");
  says(ramp + "[[0, 1]], tangential = \"free\" }\n", "tangential");
  says("[run]\nsteps = 0\n", "steps \"0\" must be a whole number, 1 or more");
  says("[wind]\nspeed = 1\n", "wind");
}

} // namespace
