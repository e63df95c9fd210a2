#include "reference/temporary_folder.hpp"

#include <cerrno>
#include <cstdlib>
#include <system_error>

namespace reference {

TemporaryFolder::TemporaryFolder(const std::string& user) {
  std::string name = (std::filesystem::temp_directory_path() / ("pfv-" + user + "-XXXXXX")).string();
  if (!mkdtemp(name.data()))
    throw std::system_error(errno, std::generic_category(), "cannot make a folder like " + name);
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

} // namespace reference
