#include "pfv/problem/error.hpp"
#include "studies/runner/build_info.hpp"
#include "support/message_of.hpp"

#include <gtest/gtest.h>

namespace studies {
namespace {

TEST(DigestOfSources, DependsOnTheFoldersNamed) {
  EXPECT_EQ(digest_of_sources({"meshing"}), digest_of_sources({"meshing"}));
  EXPECT_NE(digest_of_sources({"meshing"}), digest_of_sources({"reference/openfoam"}));
  EXPECT_NE(digest_of_sources({"meshing"}), digest_of_sources({"meshing", "reference/openfoam"}));
}

TEST(DigestOfSources, HoldsMoreOfAFolderThanOfOneInIt) {
  const auto& sources = build_info().sources;
  EXPECT_NE(sources.at("pfv"), sources.at("pfv/*"));
  EXPECT_NE(sources.at("pfv"), sources.at("pfv/problem"));
}

TEST(DigestOfSources, RefusesAFolderWithoutSources) {
  const auto message = pfv::testing::message_of<pfv::InputError>([] { digest_of_sources({"reference/nowhere"}); });
  EXPECT_NE(message.find("reference/nowhere"), std::string::npos);
}

} // namespace
} // namespace studies
