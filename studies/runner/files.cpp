#include "studies/runner/files.hpp"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <fmt/format.h>

#include <cerrno>
#include <fcntl.h>
#include <fstream>
#include <system_error>
#include <unistd.h>

namespace studies {

void write_file(const std::filesystem::path& file, std::string_view text) {
  if (file.has_parent_path())
    std::filesystem::create_directories(file.parent_path());
  const std::filesystem::path half = fmt::format("{}.{}.half", file.string(), ::getpid());
  std::ofstream out(half, std::ios::binary);
  out << text << std::flush;
  if (!out)
    throw std::system_error(errno, std::generic_category(), "cannot write " + file.string());
  out.close();
  // Else a power cut could leave the new name with nothing in it.
  if (const int descriptor = ::open(half.c_str(), O_RDONLY | O_CLOEXEC); descriptor >= 0) {
    ::fsync(descriptor);
    ::close(descriptor);
  }
  std::filesystem::rename(half, file);
}

std::string text_digest(std::string_view text) {
  const XXH128_hash_t hash = XXH3_128bits(text.data(), text.size());
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

} // namespace studies
