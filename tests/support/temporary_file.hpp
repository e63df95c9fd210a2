#pragma once

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <string_view>
#include <unistd.h>

namespace pfv::testing {

/// A file with the given text in a folder of its own, removed with the object.
class TemporaryFile {
public:
  TemporaryFile(std::string_view name, std::string_view text)
      : folder_(std::filesystem::path(::testing::TempDir()) /
                (std::string("pfv-") + ::testing::UnitTest::GetInstance()->current_test_info()->name() + "-" +
                 std::to_string(getpid()) + "-" + std::to_string(count_++))),
        path_(folder_ / name) {
    std::filesystem::create_directories(folder_);
    std::ofstream(path_, std::ios::binary) << text;
  }
  ~TemporaryFile() { std::filesystem::remove_all(folder_); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::filesystem::path& path() const { return path_; }

private:
  static inline int count_ = 0;
  std::filesystem::path folder_;
  std::filesystem::path path_;
};

} // namespace pfv::testing
