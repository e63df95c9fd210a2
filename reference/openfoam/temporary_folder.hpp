#pragma once

#include <filesystem>

namespace reference::openfoam {

/// A new folder under the system's temporary one, gone with its contents when this goes.
class TemporaryFolder {
public:
  /// Throws std::system_error when it cannot be made.
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

private:
  std::filesystem::path path_;
};

} // namespace reference::openfoam
