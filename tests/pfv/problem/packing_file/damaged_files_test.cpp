// Damaged text files are refused in one line or answered; tests/pfv/vtk does the same to VTK files.
#include "support/packing_files.hpp"

#include <gtest/gtest.h>

namespace pfv {
namespace {

class DamagedFile : public ::testing::TestWithParam<const char*> {};

TEST_P(DamagedFile, IsRefusedInOneLineOrRead) {
  testing::expect_refused_or_read(GetParam(), 500, {.box = Box{Vec3(-1, -1, -1), Vec3(3, 3, 3)}});
}

INSTANTIATE_TEST_SUITE_P(Formats, DamagedFile,
                         ::testing::Values("yade_text.txt", "yade_mat_id.txt", "yade_attrs.txt", "liggghts.dump",
                                           "liggghts_scaled.dump", "liggghts.data", "plain.txt", "table.csv"),
                         [](const auto& sample) {
                           std::string name = sample.param;
                           std::ranges::replace(name, '.', '_');
                           return name;
                         });

} // namespace
} // namespace pfv
