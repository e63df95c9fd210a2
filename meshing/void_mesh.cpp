#include "meshing/void_mesh.hpp"

#include "meshing/child_process.hpp"
#include "meshing/mesh_cache.hpp"
#include "pfv/problem/error.hpp"

#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <map>
#include <sstream>
#include <system_error>
#include <unistd.h>
#include <variant>

namespace meshing {

namespace {

namespace fs = std::filesystem;

const std::map<std::string, std::string> one_thread{{"OMP_NUM_THREADS", "1"}, {"OPENBLAS_NUM_THREADS", "1"}};

/// `$PFV_MESHER`, else in ../libexec of the running program, else where it was built.
fs::path find_mesher() {
  if (const char* chosen = std::getenv("PFV_MESHER"); chosen != nullptr && *chosen != '\0')
    return chosen;
  std::error_code error;
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  if (const fs::path beside = self.parent_path().parent_path() / "libexec" / "mesh_void"; !error && fs::exists(beside))
    return beside;
  return MESHER_PATH;
}

struct Mesher {
  fs::path program;
  std::string version;
};

struct Missing {
  std::string reason;
};

std::string read(const fs::path& file) {
  std::ifstream in(file);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::variant<Mesher, Missing> ask_for_version(const fs::path& program) {
  if (program.empty())
    return Missing{"this build has no mesher: gmsh was not found (Debian package libgmsh-dev)"};
  if (!fs::exists(program))
    return Missing{fmt::format("the mesher {} does not exist", program.string())};
  std::string log = fs::temp_directory_path() / "mesher_version_XXXXXX";
  const int descriptor = mkstemp(log.data());
  if (descriptor < 0)
    throw std::system_error(errno, std::generic_category(), fmt::format("cannot write {}", log));
  close(descriptor);
  const auto result = run_child({program, "--version"}, {.log = log, .environment = one_thread, .wall_limit = 60.0});
  const std::string said = last_lines(log, 1);
  fs::remove(log);
  if (!result.succeeded())
    return Missing{fmt::format("the mesher {} does not run ({}): {}", program.string(), result.how_it_ended(), said)};
  return Mesher{program, said};
}

/// Asked once per program, as loading gmsh takes a tenth of a second.
const std::variant<Mesher, Missing>& look_for_mesher() {
  static std::map<fs::path, std::variant<Mesher, Missing>> known;
  const fs::path program = find_mesher();
  const auto found = known.find(program);
  return found != known.end() ? found->second : known.emplace(program, ask_for_version(program)).first->second;
}

MeshCache::Made make_mesh(const Mesher& mesher, const pfv::Packing& packing, const pfv::PeriodicAxes& periodic,
                          const MeshSettings& settings, const fs::path& folder) {
  pfv::Case geometry;
  geometry.packing = packing;
  geometry.faces = pfv::flow_along(pfv::Axis::z, 1, periodic, packing.box);
  std::ofstream(folder / "case.toml") << pfv::to_toml(geometry);
  const fs::path log = folder / "mesher.log";
  const auto result =
      run_child({mesher.program, "case.toml", "void.msh", "quality.json", "--mesh-size",
                 fmt::format("{}", settings.mesh_size), "--bridge-radius", fmt::format("{}", settings.bridge_radius)},
                {.working_folder = folder, .log = log, .environment = one_thread, .wall_limit = settings.wall_limit});
  if (!result.succeeded())
    throw pfv::SolveError(fmt::format("meshing the void failed ({}): {}", result.how_it_ended(), last_lines(log)));
  return {mesh_quality_from_json(read(folder / "quality.json")), result.cpu_seconds};
}

} // namespace

VoidMesh void_mesh(const pfv::Case& problem, const MeshSettings& settings, const fs::path& cache_folder) {
  if (!(settings.mesh_size > 0))
    throw pfv::InputError(fmt::format("mesh_size {} must be positive", settings.mesh_size));
  if (!(settings.bridge_radius > 0 && settings.bridge_radius < 0.5))
    throw pfv::InputError(fmt::format("bridge_radius {} must be between 0 and 0.5", settings.bridge_radius));
  const auto& found = look_for_mesher();
  if (const auto* missing = std::get_if<Missing>(&found))
    throw pfv::SolveError(missing->reason);
  const auto& mesher = std::get<Mesher>(found);
  const MeshCache cache(fs::absolute(cache_folder));
  const pfv::PeriodicAxes periodic = periodic_axes(problem.faces);
  const std::string key = mesh_key(problem.packing, settings, mesher.version, periodic);
  if (auto known = cache.find(key))
    return *known;
  try {
    return cache.add(
        key, [&](const fs::path& folder) { return make_mesh(mesher, problem.packing, periodic, settings, folder); });
  } catch (const pfv::SolveError&) {
    throw;
  } catch (const std::exception& error) { // of the file system, or of a mesher that did not write what it should
    throw pfv::SolveError(fmt::format("meshing the void failed: {}", error.what()));
  }
}

std::optional<std::string> mesher_unavailable() {
  const auto& found = look_for_mesher();
  const auto* missing = std::get_if<Missing>(&found);
  return missing ? std::optional(missing->reason) : std::nullopt;
}

std::string mesher_version() {
  const auto& found = look_for_mesher();
  const auto* mesher = std::get_if<Mesher>(&found);
  return mesher ? mesher->version : "";
}

} // namespace meshing
