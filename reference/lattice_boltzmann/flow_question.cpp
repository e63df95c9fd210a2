#include "reference/lattice_boltzmann/flow_question.hpp"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace reference::lattice_boltzmann {

namespace {

using nlohmann::json;

json from(const pfv::Vec3& value) {
  return {value.x(), value.y(), value.z()};
}

json from(const std::vector<pfv::Vec3>& values) {
  json list = json::array();
  for (const auto& value : values)
    list.push_back(from(value));
  return list;
}

pfv::Vec3 vector(const json& value) {
  return pfv::Vec3(value.at(0).get<double>(), value.at(1).get<double>(), value.at(2).get<double>());
}

std::vector<pfv::Vec3> vectors(const json& list) {
  std::vector<pfv::Vec3> values;
  for (const json& value : list)
    values.push_back(vector(value));
  return values;
}

// JSON writes what is not a number as null.
std::vector<double> numbers(const json& list) {
  std::vector<double> values;
  for (const json& value : list)
    values.push_back(value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>());
  return values;
}

} // namespace

std::string to_json(const FlowQuestion& question) {
  json spheres = json::array();
  for (const auto& [centre, radius] : question.spheres)
    spheres.push_back({{"centre", from(centre)}, {"radius", radius}});
  json facets = json::array();
  for (const auto& facet : question.facets)
    facets.push_back(from(facet));
  return json{{"voxels", question.voxels},       {"beyond", question.beyond},
              {"axis", question.axis},           {"spheres", spheres},
              {"viscosity", question.viscosity}, {"magic", question.magic},
              {"tolerance", question.tolerance}, {"most_steps", question.most_steps},
              {"points", from(question.points)}, {"facets", facets}}
      .dump();
}

FlowQuestion flow_question_from_json(const std::string& text) {
  const json object = json::parse(text);
  FlowQuestion question;
  object.at("voxels").get_to(question.voxels);
  object.at("beyond").get_to(question.beyond);
  object.at("axis").get_to(question.axis);
  for (const json& sphere : object.at("spheres"))
    question.spheres.push_back({vector(sphere.at("centre")), sphere.at("radius")});
  object.at("viscosity").get_to(question.viscosity);
  object.at("magic").get_to(question.magic);
  object.at("tolerance").get_to(question.tolerance);
  object.at("most_steps").get_to(question.most_steps);
  question.points = vectors(object.at("points"));
  for (const json& facet : object.at("facets"))
    question.facets.push_back(vectors(facet));
  return question;
}

std::string to_json(const FlowReply& reply) {
  return json{{"fluid_voxels", reply.fluid_voxels},
              {"pocket_voxels", reply.pocket_voxels},
              {"links", reply.links},
              {"narrow_links", reply.narrow_links},
              {"solid_voxels", reply.solid_voxels},
              {"steps", reply.steps},
              {"settled", reply.settled},
              {"velocity", reply.velocity},
              {"section_velocity", reply.section_velocity},
              {"balance", reply.balance},
              {"drift", reply.drift},
              {"forces", from(reply.forces)},
              {"pressures", reply.pressures},
              {"fluxes", reply.fluxes},
              {"voxel_seconds", reply.voxel_seconds},
              {"solve_seconds", reply.solve_seconds},
              {"peak_memory", reply.peak_memory}}
      .dump();
}

FlowReply flow_reply_from_json(const std::string& text) {
  const json object = json::parse(text);
  FlowReply reply;
  object.at("fluid_voxels").get_to(reply.fluid_voxels);
  object.at("pocket_voxels").get_to(reply.pocket_voxels);
  object.at("links").get_to(reply.links);
  object.at("narrow_links").get_to(reply.narrow_links);
  object.at("solid_voxels").get_to(reply.solid_voxels);
  object.at("steps").get_to(reply.steps);
  object.at("settled").get_to(reply.settled);
  object.at("velocity").get_to(reply.velocity);
  object.at("section_velocity").get_to(reply.section_velocity);
  object.at("balance").get_to(reply.balance);
  object.at("drift").get_to(reply.drift);
  reply.forces = vectors(object.at("forces"));
  reply.pressures = numbers(object.at("pressures"));
  reply.fluxes = numbers(object.at("fluxes"));
  object.at("voxel_seconds").get_to(reply.voxel_seconds);
  object.at("solve_seconds").get_to(reply.solve_seconds);
  object.at("peak_memory").get_to(reply.peak_memory);
  return reply;
}

} // namespace reference::lattice_boltzmann
