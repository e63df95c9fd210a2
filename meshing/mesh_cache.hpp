#pragma once

#include "meshing/void_mesh.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace meshing {

/// 32 hexadecimal digits of what a mesh depends on: packing, settings and mesher. Fluid and face conditions are not
/// part of it, but for which of these are periodic, so all questions about one packing share a mesh.
std::string mesh_key(const pfv::Packing& packing, const MeshSettings& settings, const std::string& mesher,
                     const pfv::PeriodicAxes& periodic = {});

/// Meshes in a folder, one folder each, complete or not there: an entry is written aside and renamed, and its mesh is
/// checked against the size and checksum stored with it when it is taken.
class MeshCache {
public:
  explicit MeshCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// The entry, unless it is missing or damaged.
  std::optional<VoidMesh> find(const std::string& key) const;

  /// Lets `make` write `void.msh` (and anything else worth keeping) into a new folder, then makes it the entry, in
  /// place of a damaged one. A process that was faster leaves its own. The folder is removed when `make` throws, or by
  /// the next one to add when this process is killed.
  struct Made {
    MeshQuality quality;
    double cpu_seconds;
  };
  VoidMesh add(const std::string& key, const std::function<Made(const std::filesystem::path& folder)>& make) const;

private:
  std::filesystem::path folder_;
};

} // namespace meshing
