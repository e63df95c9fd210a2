#include "meshing/void_mesh.hpp"
#include "reference/on_path.hpp"
#include "reference/openfoam/openfoam.hpp"
#include "studies/runner/row_store.hpp"
#include "tests/studies/study_process.hpp"
#include "tests/studies/temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

// The real gmsh and the real OpenFOAM, each of them hindered by a script of its name that comes first: a failed row
// with the cause, the rest of the study done, nothing left behind, and the next run repairs it.
namespace {

using studies::Row;
using studies::Status;

constexpr const char* text = R"(
title = "Faults"
question = "What if a program fails?"
reference = "exact"
[budget]
wall_seconds = {}
[[method]]
name = "openfoam"
mesh_sizes = [6.0]
[[method]]
name = "exact"
mesh_sizes = [1.0]
[[case]]
id = "one"
packing = {{ generator = "simple_cubic", solid_fraction = 0.3 }}
flow = {{ axis = "z" }}
)";

// Where a program is found by PATH.
std::string place_of(const std::string& program) {
  const std::string path = std::getenv("PATH");
  for (std::size_t from = 0; from <= path.size();) {
    const std::size_t to = std::min(path.find(':', from), path.size());
    const std::filesystem::path file = std::filesystem::path(path.substr(from, to - from)) / program;
    if (std::filesystem::exists(file))
      return file.string();
    from = to + 1;
  }
  return {};
}

class Faults : public ::testing::Test {
protected:
  void SetUp() override {
    if (const auto reason = reference::make_openfoam()->unavailable())
      GTEST_SKIP() << *reason;
    write_study(600);
  }
  void write_study(double wall_seconds) { folder_.write("study.toml", fmt::format(text, wall_seconds)); }

  /// A script before `program`; asked for its version, it is the real one.
  void hinder(const std::string& program, const std::string& script) {
    const auto file = folder_.write("bin/" + program, fmt::format("#!/bin/sh\ncase \"$1\" in -help|--version) exec {0} "
                                                                  "\"$@\";; esac\n{1}\n",
                                                                  place_of(program), script));
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  }
  std::map<std::string, std::string> environment(bool hindered) const {
    std::map<std::string, std::string> result{{"PFV_MESH_CACHE", meshes().string()}};
    if (hindered)
      result["PATH"] = (folder_.path() / "bin").string() + ":" + std::getenv("PATH");
    return result;
  }
  StudyOutput run(bool hindered, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"run", folder_.path().string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return study(arguments, environment(hindered));
  }
  Row newest(const std::string& method) const {
    const auto rows = studies::read_rows(folder_.path() / "work" / "rows.csv");
    const auto found = std::find_if(rows.rbegin(), rows.rend(), [&](const Row& row) { return row.method == method; });
    return found == rows.rend() ? Row{} : *found;
  }
  std::filesystem::path meshes() const { return folder_.path() / "meshes"; }

  void expect_failure(const std::string& words) {
    const StudyOutput output = run(true);
    EXPECT_EQ(output.exit_code, 1) << output.err;
    EXPECT_EQ(newest("openfoam").status, Status::failed);
    EXPECT_NE(newest("openfoam").message.find(words), std::string::npos) << newest("openfoam").message;
    EXPECT_EQ(newest("exact").status, Status::answered) << "the study did not go on";
    const auto scratch = folder_.path() / "work" / "tmp";
    EXPECT_TRUE(!std::filesystem::exists(scratch) || std::filesystem::is_empty(scratch)) << "something was left behind";
  }
  void expect_repair() {
    write_study(600);
    const StudyOutput output = run(false, {"--retry-failed"});
    EXPECT_EQ(output.exit_code, 0) << output.err << newest("openfoam").message;
    EXPECT_EQ(newest("openfoam").status, Status::answered);
  }

  TemporaryFolder folder_;
};

TEST_F(Faults, GmshIsKilled) {
  const auto mesher = folder_.write("mesh_void", "");
  const char* chosen = std::getenv("PFV_MESHER");
  const std::string real = chosen ? chosen : MESHER;
  folder_.write("mesh_void", "#!/bin/sh\ncase \"$1\" in --version) exec " + real +
                                 " --version;; esac\necho Meshing curves; kill -9 $$\n");
  std::filesystem::permissions(mesher, std::filesystem::perms::owner_all);
  const StudyOutput output =
      study({"run", folder_.path().string()}, {{"PFV_MESH_CACHE", meshes().string()}, {"PFV_MESHER", mesher.string()}});
  EXPECT_EQ(output.exit_code, 1) << output.err;
  const std::string message = newest("openfoam").message;
  EXPECT_NE(message.find("killed by signal 9 (Killed)"), std::string::npos) << message;
  EXPECT_NE(message.find("Meshing curves"), std::string::npos) << message;
  EXPECT_EQ(newest("exact").status, Status::answered);
  EXPECT_TRUE(std::filesystem::is_empty(meshes()));
  expect_repair();
}

TEST_F(Faults, AMeshInTheCacheIsTruncatedOrChanged) {
  ASSERT_EQ(run(false).exit_code, 0);
  const double permeability = *newest("openfoam").permeability;
  const auto entry = std::filesystem::directory_iterator(meshes())->path();
  const auto mesh = entry / "void.msh";
  std::filesystem::resize_file(mesh, std::filesystem::file_size(mesh) / 2);
  ASSERT_EQ(run(false, {"--fresh"}).exit_code, 0); // it is made again
  EXPECT_EQ(*newest("openfoam").permeability, permeability);
  std::ofstream(entry / "mesh.json") << "{";
  ASSERT_EQ(run(false, {"--fresh"}).exit_code, 0);
  EXPECT_EQ(*newest("openfoam").permeability, permeability);
}

// Changed after it was checked: the converter reads half a file.
TEST_F(Faults, AMeshIsTruncatedWhileItIsUsed) {
  hinder("gmshToFoam", "head -c 3000 \"$1\" > half.msh; exec " + place_of("gmshToFoam") + " half.msh");
  expect_failure("gmshToFoam");
  expect_repair();
}

TEST_F(Faults, SimpleFoamDiverges) {
  hinder("simpleFoam", "sed -i 's/equations { U [0-9.]* }/equations { U 1.9 }/; s/equations { U [0-9.]*; }/equations { "
                       "U 1.9; }/' system/fvSolution; exec " +
                           place_of("simpleFoam"));
  expect_failure("simpleFoam");
  expect_repair();
}

// Out of iterations it says End and exits with 0.
TEST_F(Faults, SimpleFoamDoesNotConverge) {
  hinder("simpleFoam", "sed -i 's/endTime [0-9]*;/endTime 3;/' system/controlDict; exec " + place_of("simpleFoam"));
  expect_failure("did not converge");
  expect_repair();
}

TEST_F(Faults, SimpleFoamHangs) {
  write_study(8);
  hinder("simpleFoam", "touch $TMPDIR/hangs; sleep 600");
  expect_failure("stopped after");
  expect_repair();
}

TEST_F(Faults, TheDiskIsFull) {
  hinder("simpleFoam", "trap '' XFSZ; ulimit -f 16; exec " + place_of("simpleFoam"));
  expect_failure("simpleFoam");
  expect_repair();
}

TEST_F(Faults, TheDiskIsFullForTheMesh) {
  const StudyOutput output =
      study({"run", folder_.path().string()}, environment(false), 10000); // bytes, less than the mesh takes
  EXPECT_EQ(output.exit_code, 1) << output.err;
  EXPECT_EQ(newest("openfoam").status, Status::failed);
  EXPECT_NE(newest("openfoam").message.find("mesh"), std::string::npos) << newest("openfoam").message;
  EXPECT_EQ(newest("exact").status, Status::answered);
  expect_repair();
}

} // namespace
