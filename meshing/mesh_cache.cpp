#include "meshing/mesh_cache.hpp"

#include "pfv/problem/error.hpp"

#include <array>
#include <chrono>
#include <cstdlib>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <sys/file.h>
#include <system_error>
#include <unistd.h>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace meshing {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::string checksum(const fs::path& file) {
  const std::string text = read(file);
  return fmt::format("{:016x}", XXH3_64bits(text.data(), text.size()));
}

/// Throws json::exception or std::filesystem::filesystem_error when there is no sound entry.
VoidMesh read_entry(const fs::path& entry) {
  const json description = json::parse(read(entry / "mesh.json"));
  const fs::path file = entry / "void.msh";
  if (fs::file_size(file) != description.at("bytes").get<std::uintmax_t>() ||
      checksum(file) != description.at("checksum").get<std::string>())
    throw fs::filesystem_error("damaged", file, std::make_error_code(std::errc::io_error));
  return {.file = file,
          .quality = mesh_quality_from_json(description.at("quality").dump()),
          .cpu_seconds = description.at("cpu_seconds").get<double>()};
}

void write_entry(const fs::path& entry, const MeshCache::Made& made) {
  const fs::path file = entry / "void.msh";
  const json description{{"bytes", fs::file_size(file)},
                         {"checksum", checksum(file)},
                         {"cpu_seconds", made.cpu_seconds},
                         {"quality", json::parse(to_json(made.quality))}};
  std::ofstream out(entry / "mesh.json");
  out << description.dump(2) << '\n';
  if (!out.flush())
    throw std::system_error(errno, std::generic_category(), fmt::format("cannot write {}", entry.string()));
}

const std::string unfinished = "making-";

/// A folder held by this process, or nobody's any more: the lock goes with the process, however that ends.
class HeldFolder {
public:
  explicit HeldFolder(const fs::path& folder)
      : descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)),
        held_(descriptor_ >= 0 && ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) {}
  ~HeldFolder() {
    if (descriptor_ >= 0)
      ::close(descriptor_);
  }
  HeldFolder(const HeldFolder&) = delete;
  HeldFolder& operator=(const HeldFolder&) = delete;
  explicit operator bool() const { return held_; }

private:
  int descriptor_;
  bool held_;
};

/// Removes what processes that were killed left unfinished. A minute's grace: between its making and its lock a new
/// folder is nobody's.
void remove_abandoned(const fs::path& cache) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(cache, ignored)) {
    if (!entry.path().filename().string().starts_with(unfinished))
      continue;
    const auto changed = fs::last_write_time(entry.path(), ignored);
    if (fs::file_time_type::clock::now() - changed < std::chrono::minutes(1))
      continue;
    if (const HeldFolder held(entry.path()); held)
      fs::remove_all(entry.path(), ignored);
  }
}

/// A new folder beside the entries, on the same file system so that it can be renamed, removed unless it was.
class Workplace {
public:
  explicit Workplace(const fs::path& cache) {
    fs::create_directories(cache);
    remove_abandoned(cache);
    std::string name = cache / (unfinished + "XXXXXX");
    if (mkdtemp(name.data()) == nullptr)
      throw std::system_error(errno, std::generic_category(), fmt::format("cannot write to {}", cache.string()));
    folder_ = name;
    held_.emplace(folder_);
  }
  ~Workplace() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;
  const fs::path& folder() const { return folder_; }

private:
  fs::path folder_;
  std::optional<HeldFolder> held_;
};

} // namespace

std::string mesh_key(const pfv::Packing& packing, const MeshSettings& settings, const std::string& mesher,
                     const pfv::PeriodicAxes& periodic) {
  pfv::Case geometry;
  geometry.packing = packing;
  geometry.faces = pfv::flow_along(pfv::Axis::z, 1, periodic, packing.box);
  const std::string text =
      fmt::format("{} {:a} {:a} {}", pfv::digest(geometry), settings.mesh_size, settings.bridge_radius, mesher);
  const XXH128_hash_t hash = XXH3_128bits(text.data(), text.size());
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

std::optional<VoidMesh> MeshCache::find(const std::string& key) const {
  try {
    VoidMesh mesh = read_entry(folder_ / key);
    mesh.from_cache = true;
    return mesh;
  } catch (const std::exception&) { // whatever is wrong with it, it is made again
    return std::nullopt;
  }
}

VoidMesh MeshCache::add(const std::string& key, const std::function<Made(const fs::path&)>& make) const {
  const Workplace workplace(folder_);
  write_entry(workplace.folder(), make(workplace.folder()));
  const fs::path entry = folder_ / key;
  std::error_code error;
  fs::rename(workplace.folder(), entry, error);
  if (error) { // there is one: another process was faster, or it is damaged
    if (auto made_meanwhile = find(key))
      return *made_meanwhile;
    fs::remove_all(entry);
    fs::rename(workplace.folder(), entry);
  }
  return read_entry(entry);
}

std::filesystem::path default_mesh_cache() {
  const auto folder = [](const char* name) -> std::optional<fs::path> {
    const char* value = std::getenv(name);
    return value != nullptr && *value != '\0' ? std::optional<fs::path>(value) : std::nullopt;
  };
  if (const auto chosen = folder("PFV_MESH_CACHE"))
    return *chosen;
  if (const auto cache = folder("XDG_CACHE_HOME"))
    return *cache / "pfv" / "meshes";
  if (const auto home = folder("HOME"))
    return *home / ".cache" / "pfv" / "meshes";
  return fs::temp_directory_path() / "pfv" / "meshes";
}

} // namespace meshing
