#include "reference/openfoam/foam_reader.hpp"

#include "pfv/problem/error.hpp"
#include "support/message_of.hpp"
#include "support/temporary_file.hpp"

#include <gtest/gtest.h>

namespace reference::openfoam {
namespace {

using pfv::testing::message_of;
using pfv::testing::TemporaryFile;

TEST(FoamReader, ReadsListsLongShortAndConstant) {
  const TemporaryFile file("owner", "FoamFile { a b; }\n// * * * //\n3\n(\n1\n2\n3\n)\n2(4 5)\n3{7}\n");
  FoamReader in(file.path());
  in.skip_header();
  EXPECT_EQ(in.counts(), (std::vector<std::size_t>{1, 2, 3}));
  EXPECT_EQ(in.counts(), (std::vector<std::size_t>{4, 5}));
  EXPECT_EQ(in.counts(), (std::vector<std::size_t>{7, 7, 7}));
}

TEST(FoamReader, ReadsFieldsUniformAndNot) {
  const TemporaryFile file("U", "internalField   nonuniform List<vector> \n2\n(\n(1 -2e-3 3)\n(0 0 1)\n)\n;\n"
                                "value uniform 0.5;\nvalue nonuniform List<scalar> 0();\n");
  FoamReader in(file.path());
  in.skip_past("internalField");
  EXPECT_EQ(in.vector_field(2), (std::vector<pfv::Vec3>{{1, -2e-3, 3}, {0, 0, 1}}));
  in.skip_past("value");
  EXPECT_EQ(in.scalar_field(3), (std::vector<double>(3, 0.5)));
  in.skip_past("value");
  EXPECT_TRUE(in.scalar_field(0).empty());
}

TEST(FoamReader, NamesTheFileThatIsNotAsExpected) {
  const TemporaryFile file("p", "internalField nonuniform List<scalar> 2(1 nan?)");
  FoamReader in(file.path());
  in.skip_past("internalField");
  EXPECT_NE(message_of<pfv::SolveError>([&] { in.scalar_field(3); }).find("file p"), std::string::npos);
  EXPECT_NE(message_of<pfv::SolveError>([&] { FoamReader(file.path().parent_path() / "phi"); }).find("phi"),
            std::string::npos);
}

} // namespace
} // namespace reference::openfoam
