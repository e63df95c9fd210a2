#include "reference/answer.hpp"

#include "pfv/problem/error.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace reference {
namespace {

Answer full_answer() {
  Answer answer;
  answer.method = "some \"method\"";
  answer.mesh_size = 0.1;
  answer.unknowns = 123456789012;
  answer.permeability = 1.0 / 3.0;
  answer.face_flux = {-1e-300, 1.7976931348623157e308, 0, -0.1, 5e-324, 2};
  answer.porosity = 0.1 + 0.2;
  answer.sphere_forces = std::vector<pfv::Vec3>{{1.0 / 7, -2e-9, 0}, {3, 4, 5}};
  answer.sphere_viscous_forces = std::vector<pfv::Vec3>{{1e-9, 0, 0.1}, {1, 2, 0}};
  answer.wall_forces.emplace();
  answer.wall_forces->fill({0.1, 0.2, 0.3});
  answer.stages = {{"mesh", 1.5}, {"solve", 0.1}};
  answer.counts = {{"iterations", 12}, {"flux_imbalance", 1e-17}};
  answer.notes = {{"version", "1 \u00b5m \n"}};
  return answer;
}

void expect_equal(const Answer& a, const Answer& b) {
  EXPECT_EQ(a.method, b.method);
  EXPECT_EQ(a.mesh_size, b.mesh_size);
  EXPECT_EQ(a.unknowns, b.unknowns);
  EXPECT_EQ(a.permeability, b.permeability);
  EXPECT_EQ(a.face_flux, b.face_flux);
  EXPECT_EQ(a.porosity, b.porosity);
  EXPECT_EQ(a.sphere_forces, b.sphere_forces);
  EXPECT_EQ(a.sphere_viscous_forces, b.sphere_viscous_forces);
  EXPECT_EQ(a.wall_forces, b.wall_forces);
  EXPECT_EQ(a.stages, b.stages);
  EXPECT_EQ(a.counts, b.counts);
  EXPECT_EQ(a.notes, b.notes);
}

TEST(AnswerJson, ReadsBackToTheSameBits) {
  expect_equal(answer_from_json(to_json(full_answer())), full_answer());
}

TEST(AnswerJson, KeepsWhatIsAbsentAbsent) {
  const Answer empty;
  const std::string text = to_json(empty);
  for (const char* key : {"permeability", "porosity", "sphere_forces", "sphere_viscous_forces", "wall_forces"})
    EXPECT_FALSE(nlohmann::json::parse(text).contains(key)) << key;
  expect_equal(answer_from_json(text), empty);
}

TEST(AnswerJson, KeepsAnEmptyListOfForcesPresent) {
  Answer answer;
  answer.sphere_forces.emplace();
  EXPECT_TRUE(answer_from_json(to_json(answer)).sphere_forces.has_value());
}

TEST(AnswerJson, KeepsNotANumber) {
  Answer answer;
  answer.permeability = std::nan("");
  EXPECT_TRUE(std::isnan(answer_from_json(to_json(answer)).permeability.value()));
}

TEST(AnswerJson, RefusesWhatIsNotAnAnswer) {
  EXPECT_THROW(answer_from_json("{"), pfv::InputError);
  EXPECT_THROW(answer_from_json("[]"), pfv::InputError);
  EXPECT_THROW(answer_from_json(R"({"method": 3})"), pfv::InputError);
}

} // namespace
} // namespace reference
