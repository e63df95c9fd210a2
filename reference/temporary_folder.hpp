#pragma once

#include <filesystem>
#include <string>

namespace reference {

/// A new folder "pfv-<user>-..." under the system's temporary one, gone with its contents when this goes.
class TemporaryFolder {
public:
  /// Throws std::system_error when it cannot be made.
  explicit TemporaryFolder(const std::string& user);
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

private:
  std::filesystem::path path_;
};

} // namespace reference
