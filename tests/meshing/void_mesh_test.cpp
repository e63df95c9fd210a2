#include "meshing/void_mesh.hpp"

#include "meshing/contact_bridges.hpp"
#include "meshing/read_msh.hpp"
#include "pfv/problem/error.hpp"
#include "pfv/problem/generate.hpp"
#include "support/message_of.hpp"
#include "support/temporary_folder.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <set>

namespace {

using meshing::VoidMesh;
using pfv::Lattice;
using pfv::Vec3;
using pfv::testing::message_of;

pfv::Case case_of(pfv::Packing packing) {
  pfv::Case problem;
  problem.packing = std::move(packing);
  problem.faces = pfv::flow_along(pfv::Axis::z);
  return problem;
}

pfv::Packing touching(Lattice lattice) {
  return pfv::lattice_packing(lattice, pfv::touching_solid_fraction(lattice), 1);
}

class VoidMeshTest : public testing::Test {
protected:
  void SetUp() override {
    if (const auto reason = meshing::mesher_unavailable())
      GTEST_SKIP() << *reason;
  }
  VoidMesh mesh(const pfv::Packing& packing, double mesh_size) const {
    return meshing::void_mesh(case_of(packing), {.mesh_size = mesh_size}, cache_.path());
  }

  pfv::testing::TemporaryFolder cache_;
};

/// What is known beforehand about the void of a packing.
struct Known {
  const char* name;
  pfv::Packing packing;
  std::size_t bridges;
  double volume_error[2]; // bound at mesh_size 2 and 1: chords of spheres less what bridges take away
  friend void PrintTo(const Known& known, std::ostream* out) { *out << known.name; }
};

class KnownVoid : public VoidMeshTest, public testing::WithParamInterface<Known> {};

std::string surface_of(const meshing::LinearMesh& mesh, const meshing::LinearMesh::Triangle& triangle) {
  return mesh.surfaces.at(static_cast<std::size_t>(triangle.surface));
}

/// Largest distance of the nodes of a surface from where they should be, in units of the sphere's radius.
double distance_from(const std::string& surface, const meshing::LinearMesh& mesh, const pfv::Packing& packing,
                     const std::vector<meshing::Bridge>& bridges) {
  double largest = 0;
  for (const auto& triangle : mesh.triangles) {
    if (surface_of(mesh, triangle) != surface)
      continue;
    for (const int n : triangle.nodes) {
      const Vec3& node = mesh.nodes.at(static_cast<std::size_t>(n));
      double off = 1;
      if (surface.starts_with("sphere_")) {
        const auto& [centre, radius] = packing.spheres.at(std::stoul(surface.substr(7)));
        off = (node - centre).norm() / radius - 1;
      } else if (surface.starts_with("bridge_")) {
        const auto& bridge = *std::ranges::find(bridges, surface, &meshing::Bridge::name);
        off = (node - bridge.from).cross((bridge.to - bridge.from).normalized()).norm() / bridge.radius - 1;
      } else {
        const auto face = pfv::all_faces.at(
            static_cast<std::size_t>(std::ranges::find(pfv::face_names, surface) - pfv::face_names.begin()));
        const int axis = pfv::index(pfv::axis_of(face));
        off = node[axis] - (pfv::is_upper(face) ? packing.box.upper : packing.box.lower)[axis];
        EXPECT_EQ(off, 0); // exactly
      }
      largest = std::max(largest, std::abs(off));
    }
  }
  return largest;
}

TEST_P(KnownVoid, IsMeshedAndNamedWhole) {
  const auto& [name, packing, bridge_count, bounds] = GetParam();
  const auto bridges = meshing::contact_bridges(packing, meshing::MeshSettings{}.bridge_radius);
  ASSERT_EQ(bridges.size(), bridge_count);
  std::set<std::string> expected{pfv::face_names.begin(), pfv::face_names.end()};
  for (std::size_t k = 0; k < packing.spheres.size(); ++k)
    expected.insert("sphere_" + std::to_string(k));
  for (const auto& bridge : bridges)
    expected.insert(bridge.name);

  for (const int level : {0, 1}) {
    const auto made = this->mesh(packing, level == 0 ? 2 : 1);
    const auto mesh = meshing::testing::read_msh(made.file);
    EXPECT_NO_THROW(meshing::check(mesh));
    EXPECT_EQ(std::set(mesh.surfaces.begin(), mesh.surfaces.end()), expected);
    for (const std::string& surface : mesh.surfaces) {
      EXPECT_TRUE(std::ranges::any_of(mesh.triangles, [&](const auto& t) { return surface_of(mesh, t) == surface; }));
      EXPECT_LT(distance_from(surface, mesh, packing, bridges), 1e-6) << surface;
    }
    EXPECT_EQ(made.quality.nodes, mesh.nodes.size());
    EXPECT_EQ(made.quality.tetrahedra, mesh.tetrahedra.size());
    EXPECT_EQ(made.quality.bridges, bridge_count);
    EXPECT_EQ(made.quality.parts, 1);
    EXPECT_EQ(made.quality.enclosed_parts, 0);
    EXPECT_GT(made.quality.worst_quality, 0.01);
    EXPECT_LT(std::abs(made.quality.volume_error), bounds[level]);
    EXPECT_GT(made.cpu_seconds, 0);
  }
}

// Bounds a third above what was measured: 1.6 and 1.0 %, 3.1 and 1.1, 3.5 and 1.2, 1.8 and 0.8, 1.6 and 0.7, 1.0 and
// 0.3.
INSTANTIATE_TEST_SUITE_P(
    Packings, KnownVoid,
    testing::Values(Known{"simple_cubic", touching(Lattice::simple_cubic), 6, {0.022, 0.014}},
                    Known{"bcc", touching(Lattice::bcc), 8, {0.04, 0.015}},
                    Known{"fcc", touching(Lattice::fcc), 36, {0.046, 0.016}},
                    Known{"nine_spheres", pfv::nine_spheres(), 32, {0.024, 0.012}},
                    Known{"random", pfv::random_packing({.spheres = 10, .solid_fraction = 0.4}), 25, {0.022, 0.01}},
                    Known{"loose_bcc", pfv::lattice_packing(Lattice::bcc, 0.3, 1), 0, {0.04, 0.012}}),
    [](const auto& instance) { return std::string(instance.param.name); });

TEST_F(VoidMeshTest, VolumeAndSurfaceOfSpheresCutByTheBoxConverge) {
  pfv::Packing packing; // in the middle, through a face, on an edge, on a corner
  packing.spheres = {{{0.5, 0.5, 0.5}, 0.2}, {{0.5, 0.5, 0.9}, 0.15}, {{0, 0, 0.5}, 0.3}, {{1, 1, 0}, 0.25}};
  const auto coarse = mesh(packing, 2).quality;
  const auto fine = mesh(packing, 1).quality;
  EXPECT_LT(std::abs(fine.volume_error), std::abs(coarse.volume_error) / 3);
  EXPECT_LT(std::abs(fine.surface_error), std::abs(coarse.surface_error) / 3);
  EXPECT_LT(std::abs(fine.volume_error), 0.003);
  EXPECT_LT(std::abs(fine.surface_error), 0.015);
}

TEST_F(VoidMeshTest, OverlappingSpheresNeedNoBridge) {
  pfv::Packing packing;
  packing.spheres = {{{0.35, 0.5, 0.5}, 0.2}, {{0.65, 0.5, 0.5}, 0.2}, {{0.5, 0.5, 0.95}, 0.15}};
  const auto made = mesh(packing, 2);
  EXPECT_EQ(made.quality.bridges, 0);
  EXPECT_LT(std::abs(made.quality.volume_error), 0.02);
  EXPECT_LT(std::abs(made.quality.surface_error), 0.07);
}

// Spheres of an fcc lattice so large that they close its throats: the voids inside the cell are left out, the twelve
// quarters of octahedral voids around the cell's edges stay, apart from each other.
TEST_F(VoidMeshTest, EnclosedVoidsAreLeftOutAndCounted) {
  auto packing = touching(Lattice::fcc);
  for (auto& sphere : packing.spheres)
    sphere.radius = 0.412;
  const auto made = mesh(packing, 2);
  EXPECT_EQ(made.quality.parts, 12);
  EXPECT_EQ(made.quality.enclosed_parts, 9);
}

TEST_F(VoidMeshTest, TheSameQuestionGivesTheSameFile) {
  const auto text = [&](const VoidMesh& made) {
    std::ifstream in(made.file, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  const auto packing = pfv::random_packing({.spheres = 6, .solid_fraction = 0.3, .radius_ratio = 2});
  const pfv::testing::TemporaryFolder other_cache;
  const auto here = mesh(packing, 2);
  const auto there = meshing::void_mesh(case_of(packing), {.mesh_size = 2}, other_cache.path());
  EXPECT_NE(here.file, there.file);
  EXPECT_FALSE(there.from_cache);
  EXPECT_EQ(text(here), text(there));
}

TEST_F(VoidMeshTest, LengthsScale) {
  auto packing = pfv::lattice_packing(Lattice::bcc, 0.5, 1);
  const auto metres = mesh(packing, 2).quality;
  packing = pfv::lattice_packing(Lattice::bcc, 0.5, 1, 1e-5);
  const auto small = mesh(packing, 2).quality;
  EXPECT_NEAR(small.volume / metres.volume / 1e-15, 1, 1e-3);
  EXPECT_NEAR(small.surface / metres.surface / 1e-10, 1, 1e-3);
}

TEST_F(VoidMeshTest, ComesFromTheCacheTheSecondTime) {
  auto problem = case_of(pfv::lattice_packing(Lattice::bcc, 0.3, 1));
  const auto first = meshing::void_mesh(problem, {.mesh_size = 3}, cache_.path());
  EXPECT_FALSE(first.from_cache);
  problem.fluid.viscosity = 2;
  problem.faces = pfv::flow_along(pfv::Axis::x, 7);
  problem.name = "another";
  const auto second = meshing::void_mesh(problem, {.mesh_size = 3}, cache_.path());
  EXPECT_TRUE(second.from_cache);
  EXPECT_EQ(second.file, first.file);
  EXPECT_EQ(second.quality, first.quality);
  EXPECT_EQ(second.cpu_seconds, first.cpu_seconds);
  const auto finer = meshing::void_mesh(problem, {.mesh_size = 2.5}, cache_.path());
  EXPECT_FALSE(finer.from_cache);
  EXPECT_GT(finer.quality.tetrahedra, first.quality.tetrahedra);

  std::filesystem::resize_file(first.file, 100);
  const auto repaired = meshing::void_mesh(problem, {.mesh_size = 3}, cache_.path());
  EXPECT_FALSE(repaired.from_cache);
  EXPECT_EQ(repaired.quality, first.quality);
  EXPECT_GT(std::filesystem::file_size(repaired.file), 100U);
}

/// A shell script in place of the mesher.
class WithAnotherMesher : public testing::Test {
protected:
  ~WithAnotherMesher() override { unsetenv("PFV_MESHER"); }
  void use(const std::string& script) const {
    const auto program = folder_.path() / "mesher";
    std::ofstream(program) << "#!/bin/sh\n" << script << '\n';
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    setenv("PFV_MESHER", program.c_str(), 1);
  }
  std::string fault(const meshing::MeshSettings& settings = {}) const {
    const auto cache = folder_.path() / "meshes";
    const auto message =
        message_of<pfv::SolveError>([&] { meshing::void_mesh(case_of(pfv::nine_spheres()), settings, cache); });
    EXPECT_TRUE(!std::filesystem::exists(cache) || std::filesystem::is_empty(cache));
    return message;
  }

  pfv::testing::TemporaryFolder folder_;
};

const std::string knows_its_version = "[ \"$1\" = --version ] && echo fake 1 && exit 0\n";

TEST_F(WithAnotherMesher, LastWordsAreQuoted) {
  use(knows_its_version + "echo fine; echo >&2 gmsh: no way; exit 3");
  EXPECT_EQ(meshing::mesher_version(), "fake 1");
  const auto message = fault();
  EXPECT_NE(message.find("exit code 3"), std::string::npos) << message;
  EXPECT_NE(message.find("gmsh: no way"), std::string::npos) << message;
}

TEST_F(WithAnotherMesher, ACrashIsAnAnswer) {
  use(knows_its_version + "kill -ABRT $$");
  EXPECT_NE(fault().find("killed by signal 6"), std::string::npos);
}

TEST_F(WithAnotherMesher, TakingTooLongIsAnAnswer) {
  use(knows_its_version + "exec sleep 60");
  EXPECT_NE(fault({.wall_limit = 0.2}).find("stopped after"), std::string::npos);
}

TEST_F(WithAnotherMesher, SuccessWithoutAMeshIsAFailure) {
  use(knows_its_version + "echo {} > quality.json");
  EXPECT_NE(fault().find("quality"), std::string::npos);
  use(knows_its_version + "exit 0");
  EXPECT_NE(fault(), "no error");
}

TEST_F(WithAnotherMesher, ACacheThatCannotBeWrittenIsAnAnswer) {
  use(knows_its_version + "exit 0");
  std::ofstream(folder_.path() / "file") << "not a folder";
  const auto message = message_of<pfv::SolveError>(
      [&] { meshing::void_mesh(case_of(pfv::nine_spheres()), {}, folder_.path() / "file" / "meshes"); });
  EXPECT_NE(message.find("file/meshes"), std::string::npos) << message;
}

TEST_F(WithAnotherMesher, OneThatDoesNotRunIsUnavailable) {
  setenv("PFV_MESHER", "/no/such/mesher", 1);
  ASSERT_TRUE(meshing::mesher_unavailable());
  EXPECT_NE(meshing::mesher_unavailable()->find("/no/such/mesher"), std::string::npos);
  EXPECT_EQ(meshing::mesher_version(), "");
  EXPECT_NE(fault().find("/no/such/mesher"), std::string::npos);
}

TEST(VoidMeshSettings, OutOfRangeAreRefused) {
  const auto fault = [](const meshing::MeshSettings& settings) {
    return message_of<pfv::InputError>(
        [&] { meshing::void_mesh(case_of(pfv::nine_spheres()), settings, "/no/such/cache"); });
  };
  EXPECT_NE(fault({.mesh_size = 0}).find("mesh_size"), std::string::npos);
  EXPECT_NE(fault({.mesh_size = std::nan("")}).find("mesh_size"), std::string::npos);
  EXPECT_NE(fault({.bridge_radius = 0.5}).find("bridge_radius"), std::string::npos);
}

} // namespace
