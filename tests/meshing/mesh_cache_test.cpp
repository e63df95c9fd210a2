#include "meshing/mesh_cache.hpp"

#include "pfv/problem/generate.hpp"
#include "support/temporary_folder.hpp"

#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <stdexcept>

namespace {

namespace fs = std::filesystem;
using meshing::mesh_key;
using meshing::MeshCache;
using meshing::MeshSettings;

class MeshCacheTest : public testing::Test {
protected:
  static void write(const fs::path& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }
  static std::string read(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  static auto maker(const std::string& mesh) {
    return [mesh](const fs::path& folder) {
      write(folder / "void.msh", mesh);
      return MeshCache::Made{{.nodes = mesh.size(), .worst_quality = 0.5}, 12.5};
    };
  }
  std::size_t entries() const {
    return fs::exists(folder()) ? static_cast<std::size_t>(std::distance(fs::directory_iterator(folder()), {})) : 0;
  }
  fs::path folder() const { return temporary_.path() / "meshes"; }

  pfv::testing::TemporaryFolder temporary_;
  MeshCache cache_{folder()};
};

TEST_F(MeshCacheTest, KeepsWhatIsAdded) {
  EXPECT_FALSE(cache_.find("key"));
  const auto made = cache_.add("key", maker("a mesh"));
  EXPECT_FALSE(made.from_cache);
  EXPECT_EQ(made.file, folder() / "key" / "void.msh");
  const auto found = cache_.find("key");
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->from_cache);
  EXPECT_EQ(found->file, made.file);
  EXPECT_EQ(found->quality, made.quality);
  EXPECT_EQ(found->cpu_seconds, 12.5);
  EXPECT_EQ(read(found->file), "a mesh");
  EXPECT_EQ(entries(), 1);
}

TEST_F(MeshCacheTest, DamagedEntriesAreNotFoundAndMadeAgain) {
  const fs::path entry = folder() / "key";
  const std::vector<std::function<void()>> damages{
      [&] { fs::resize_file(entry / "void.msh", 3); },
      [&] { write(entry / "void.msh", "A mesh"); }, // same size
      [&] { fs::remove(entry / "void.msh"); },
      [&] { fs::remove(entry / "mesh.json"); },
      [&] { fs::resize_file(entry / "mesh.json", fs::file_size(entry / "mesh.json") / 2); },
      [&] { write(entry / "mesh.json", "{}"); },
  };
  for (const auto& damage : damages) {
    cache_.add("key", maker("a mesh"));
    ASSERT_TRUE(cache_.find("key"));
    damage();
    EXPECT_FALSE(cache_.find("key"));
    EXPECT_EQ(read(cache_.add("key", maker("a mesh")).file), "a mesh");
    EXPECT_TRUE(cache_.find("key"));
    EXPECT_EQ(entries(), 1);
  }
}

TEST_F(MeshCacheTest, TheFirstOfTwoProcessesWins) {
  const auto result = cache_.add("key", [&](const fs::path& other) {
    MeshCache(folder()).add("key", maker("first"));
    return maker("second")(other);
  });
  EXPECT_TRUE(result.from_cache);
  EXPECT_EQ(read(result.file), "first");
  EXPECT_EQ(entries(), 1);
}

TEST_F(MeshCacheTest, AFailureLeavesNothing) {
  EXPECT_THROW(cache_.add("key",
                          [](const fs::path& there) -> MeshCache::Made {
                            write(there / "void.msh", "half a m");
                            throw std::runtime_error("gmsh");
                          }),
               std::runtime_error);
  EXPECT_FALSE(cache_.find("key"));
  EXPECT_EQ(entries(), 0);
}

TEST_F(MeshCacheTest, KeysFollowPackingSettingsAndMesher) {
  const auto nine = pfv::nine_spheres();
  const std::string key = mesh_key(nine, {}, "gmsh 4");
  EXPECT_EQ(key.size(), 32);
  EXPECT_EQ(mesh_key(nine, {}, "gmsh 4"), key);
  EXPECT_EQ(mesh_key(nine, {.wall_limit = 1}, "gmsh 4"), key);
  EXPECT_NE(mesh_key(nine, {}, "gmsh 5"), key);
  EXPECT_NE(mesh_key(nine, {.mesh_size = 1 + 1e-15}, "gmsh 4"), key);
  EXPECT_NE(mesh_key(nine, {.bridge_radius = 0.19}, "gmsh 4"), key);
  auto moved = nine;
  moved.spheres[8].centre.x() += 1e-15;
  EXPECT_NE(mesh_key(moved, {}, "gmsh 4"), key);
  auto renumbered = nine; // the names of the surfaces change
  std::swap(renumbered.spheres[0], renumbered.spheres[1]);
  EXPECT_NE(mesh_key(renumbered, {}, "gmsh 4"), key);
}

TEST(DefaultMeshCache, FollowsTheEnvironment) {
  setenv("HOME", "/home/me", 1);
  unsetenv("PFV_MESH_CACHE");
  unsetenv("XDG_CACHE_HOME");
  EXPECT_EQ(meshing::default_mesh_cache(), "/home/me/.cache/pfv/meshes");
  setenv("XDG_CACHE_HOME", "/cache", 1);
  EXPECT_EQ(meshing::default_mesh_cache(), "/cache/pfv/meshes");
  setenv("PFV_MESH_CACHE", "/meshes", 1);
  EXPECT_EQ(meshing::default_mesh_cache(), "/meshes");
}

} // namespace
