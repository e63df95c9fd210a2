#include "pfv/problem/error.hpp"
#include "pfv/problem/text.hpp"
#include "pfv/simulation/checkpoint.hpp"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <cerrno>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <sstream>
#include <system_error>
#include <unistd.h>

namespace pfv {
namespace {

constexpr std::string_view beginning = "pfv checkpoint ";
constexpr int version = 2;

std::string digest_of(std::string_view bytes) {
  const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

/// The CBOR of a file that is what its first line says.
std::string_view checked(std::string_view text) {
  if (!text.starts_with(beginning))
    throw InputError("not a checkpoint of pfv run");
  const std::size_t end = text.find('\n');
  if (end == text.npos)
    throw InputError("truncated: its first line has no end");
  std::istringstream line{std::string(text.substr(beginning.size(), end - beginning.size()))};
  std::string of, digest;
  std::size_t size = 0;
  line >> of >> size >> digest;
  if (of != fmt::format("{}", version))
    throw InputError(fmt::format("a checkpoint of version \"{}\"; this pfv reads version {}", of, version));
  const std::string_view bytes = text.substr(end + 1);
  if (bytes.size() < size)
    throw InputError(fmt::format("truncated: {} bytes of \"{}\" are there", bytes.size(), size));
  if (bytes.size() != size || digest_of(bytes) != digest)
    throw InputError(fmt::format("damaged: what it holds is not of the digest \"{}\"", digest));
  return bytes;
}

/// Where a file is written before it takes its name.
std::filesystem::path half_of(const std::filesystem::path& file) {
  return fmt::format("{}.{}.half", file.string(), ::getpid());
}

[[noreturn]] void fail_to_write(const std::filesystem::path& file, int reason) {
  std::error_code ignored;
  std::filesystem::remove(half_of(file), ignored);
  throw InputError(
      fmt::format("checkpoint \"{}\" cannot be written: {}", file.string(), std::generic_category().message(reason)));
}

} // namespace

void write_checkpoint(const std::filesystem::path& file, const Checkpoint& checkpoint) {
  const std::string bytes = to_bytes(checkpoint);
  const auto half = half_of(file);
  errno = 0;
  std::ofstream out(half, std::ios::binary);
  out << beginning << version << ' ' << bytes.size() << ' ' << digest_of(bytes) << '\n' << bytes << std::flush;
  if (!out)
    fail_to_write(file, errno);
  out.close();
  // Else a power cut could leave the new name with nothing in it.
  if (const int descriptor = ::open(half.c_str(), O_RDONLY | O_CLOEXEC); descriptor >= 0) {
    ::fsync(descriptor);
    ::close(descriptor);
  }
  std::error_code error;
  std::filesystem::rename(half, file, error);
  if (error)
    fail_to_write(file, error.value());
}

void require_writable(const std::filesystem::path& file) {
  const auto half = half_of(file);
  errno = 0;
  if (!std::ofstream(half))
    fail_to_write(file, errno);
  std::filesystem::remove(half);
  if (std::filesystem::is_directory(file))
    fail_to_write(file, EISDIR);
}

Checkpoint read_checkpoint(const std::filesystem::path& file) {
  const std::string text = read_text(file);
  try {
    return from_bytes(checked(text));
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", file.string(), error.what()));
  }
}

} // namespace pfv
