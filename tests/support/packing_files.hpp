#pragma once

#include "pfv/problem/error.hpp"
#include "pfv/problem/packing_file.hpp"
#include "support/message_of.hpp"
#include "support/temporary_file.hpp"

#include <random>
#include <string>
#include <string_view>

namespace pfv::testing {

inline std::filesystem::path format_sample(const std::string& name) {
  return std::filesystem::path(TEST_DATA) / "formats" / name;
}

/// What read_packing_file says of a file with this name and text, without the folder.
inline std::string complaint_of(std::string_view name, std::string_view text, const PackingFileOptions& options = {}) {
  const TemporaryFile file(name, text);
  std::string message = message_of<InputError>([&] { read_packing_file(file.path(), options); });
  const std::string folder = file.path().parent_path().string() + "/";
  if (message.starts_with(folder))
    message.erase(0, folder.size());
  return message;
}

inline ReadPacking read_text_as(std::string_view name, std::string_view text, const PackingFileOptions& options = {},
                                const PeriodicAxes& periodic = {}) {
  const TemporaryFile file(name, text);
  return read_packing_file(file.path(), options, periodic);
}

/// The contents with something cut off, put in, taken out or exchanged.
inline std::string damaged(std::string contents, std::mt19937& random) {
  const auto below = [&](std::size_t bound) {
    return std::uniform_int_distribution<std::size_t>(0, bound - 1)(random);
  };
  const std::size_t at = below(contents.size());
  constexpr std::string_view characters = "0123456789-+.eE \t\n#,_<>\"x";
  switch (below(5)) {
  case 0:
    return contents.substr(0, at);
  case 1:
    contents[at] = static_cast<char>(below(256));
    return contents;
  case 2:
    contents[at] = characters[below(characters.size())];
    return contents;
  case 3:
    return contents.erase(at, 1 + below(40));
  default:
    return contents.insert(at, std::to_string(below(1'000'000'000)));
  }
}

/// Damaged copies of a file are refused in one line or read as a packing that validate() has passed.
inline void expect_refused_or_read(const std::string& sample, int copies, const PackingFileOptions& options) {
  const std::string contents = [&] {
    std::ifstream in(format_sample(sample), std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  }();
  ASSERT_FALSE(contents.empty()) << sample;
  std::mt19937 random(1);
  int refused = 0;
  for (int i = 0; i < copies; ++i) {
    const TemporaryFile file(sample, damaged(contents, random));
    try {
      EXPECT_FALSE(read_packing_file(file.path(), options).packing.spheres.empty());
    } catch (const InputError& error) {
      const std::string message = error.what();
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      EXPECT_EQ(message.find(file.path().string()), 0U) << message;
      ++refused;
    }
  }
  EXPECT_GT(refused, copies / 10) << sample;
}

} // namespace pfv::testing
