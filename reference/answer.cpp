#include "reference/answer.hpp"

#include "pfv/problem/error.hpp"

#include <nlohmann/json.hpp>

#include <limits>

namespace reference {

namespace {

using nlohmann::json;

json written(const pfv::Vec3& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

template <class Vectors>
json written_all(const Vectors& vectors) {
  json list = json::array();
  for (const pfv::Vec3& vector : vectors)
    list.push_back(written(vector));
  return list;
}

// JSON has no NaN: a number that is not finite is written as null.
double number(const json& value) {
  return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

std::vector<double> numbers(const json& values) {
  std::vector<double> list;
  for (const json& value : values)
    list.push_back(number(value));
  return list;
}

pfv::Vec3 vector(const json& value) {
  return {number(value.at(0)), number(value.at(1)), number(value.at(2))};
}

std::vector<pfv::Vec3> vectors(const json& list) {
  std::vector<pfv::Vec3> read;
  for (const json& one : list)
    read.push_back(vector(one));
  return read;
}

Answer parse(const json& object) {
  Answer answer;
  answer.method = object.at("method");
  answer.mesh_size = number(object.at("mesh_size"));
  answer.unknowns = object.at("unknowns");
  const json& flux = object.at("face_flux");
  for (std::size_t face = 0; face < 6; ++face)
    answer.face_flux[face] = number(flux.at(face));
  if (object.contains("permeability"))
    answer.permeability = number(object["permeability"]);
  if (object.contains("porosity"))
    answer.porosity = number(object["porosity"]);
  if (object.contains("sphere_forces"))
    answer.sphere_forces = vectors(object["sphere_forces"]);
  if (object.contains("sphere_viscous_forces"))
    answer.sphere_viscous_forces = vectors(object["sphere_viscous_forces"]);
  if (object.contains("wall_forces")) {
    answer.wall_forces.emplace();
    for (std::size_t face = 0; face < 6; ++face)
      (*answer.wall_forces)[face] = vector(object["wall_forces"].at(face));
  }
  if (object.contains("point_pressures"))
    answer.point_pressures = numbers(object["point_pressures"]);
  if (object.contains("facet_fluxes"))
    answer.facet_fluxes = numbers(object["facet_fluxes"]);
  for (const json& stage : object.at("stages"))
    answer.stages.push_back({stage.at("name"), number(stage.at("cpu_seconds"))});
  for (const auto& [name, value] : object.at("counts").items())
    answer.counts[name] = number(value);
  for (const auto& [name, value] : object.at("notes").items())
    answer.notes[name] = value;
  return answer;
}

} // namespace

std::string to_json(const Answer& answer) {
  json object{{"method", answer.method},       {"mesh_size", answer.mesh_size}, {"unknowns", answer.unknowns},
              {"face_flux", answer.face_flux}, {"stages", json::array()},       {"counts", json::object()},
              {"notes", json::object()}};
  if (answer.permeability)
    object["permeability"] = *answer.permeability;
  if (answer.porosity)
    object["porosity"] = *answer.porosity;
  if (answer.sphere_forces)
    object["sphere_forces"] = written_all(*answer.sphere_forces);
  if (answer.sphere_viscous_forces)
    object["sphere_viscous_forces"] = written_all(*answer.sphere_viscous_forces);
  if (answer.wall_forces)
    object["wall_forces"] = written_all(*answer.wall_forces);
  if (answer.point_pressures)
    object["point_pressures"] = *answer.point_pressures;
  if (answer.facet_fluxes)
    object["facet_fluxes"] = *answer.facet_fluxes;
  for (const pfv::Stage& stage : answer.stages)
    object["stages"].push_back({{"name", stage.name}, {"cpu_seconds", stage.cpu_seconds}});
  for (const auto& [name, value] : answer.counts)
    object["counts"][name] = value;
  for (const auto& [name, value] : answer.notes)
    object["notes"][name] = value;
  return object.dump();
}

Answer answer_from_json(const std::string& text) {
  try {
    return parse(json::parse(text));
  } catch (const json::exception& error) {
    throw pfv::InputError("not an answer in JSON: " + std::string(error.what()));
  }
}

} // namespace reference
