#include "studies/render/scene.hpp"

#include "pfv/problem/error.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace studies {

namespace {

using Json = nlohmann::json;

Json json_of(const pfv::Vec3& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

Json json_of(const pfv::Box& box) {
  return {json_of(box.lower), json_of(box.upper)};
}

pfv::Vec3 vector_from(const Json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

pfv::Box box_from(const Json& json) {
  return {vector_from(json.at(0)), vector_from(json.at(1))};
}

} // namespace

std::string to_json(const RenderScene& scene) {
  Json json{{"box", json_of(scene.box)},         {"towards_eye", json_of(scene.towards_eye)},
            {"upwards", json_of(scene.upwards)}, {"pieces", Json::array()},
            {"spheres", Json::array()},          {"panels", Json::array()}};
  for (const pfv::Box& piece : scene.pieces)
    json["pieces"].push_back(json_of(piece));
  for (const pfv::Sphere& sphere : scene.spheres)
    json["spheres"].push_back({{"centre", json_of(sphere.centre)}, {"radius", sphere.radius}});
  for (const Panel& panel : scene.panels)
    json["panels"].push_back({{"corner", json_of(panel.corner)},
                              {"across", json_of(panel.across)},
                              {"up", json_of(panel.up)},
                              {"columns", panel.columns},
                              {"rows", panel.rows},
                              {"colours", panel.colours}});
  return json.dump();
}

RenderScene render_scene_from(std::string_view text) {
  try {
    const Json json = Json::parse(text);
    RenderScene scene{box_from(json.at("box")),       {}, {}, {}, vector_from(json.at("towards_eye")),
                      vector_from(json.at("upwards"))};
    for (const Json& piece : json.at("pieces"))
      scene.pieces.push_back(box_from(piece));
    for (const Json& sphere : json.at("spheres"))
      scene.spheres.push_back({vector_from(sphere.at("centre")), sphere.at("radius").get<double>()});
    for (const Json& panel : json.at("panels")) {
      scene.panels.push_back({vector_from(panel.at("corner")),
                              vector_from(panel.at("across")),
                              vector_from(panel.at("up")),
                              panel.at("columns").get<int>(),
                              panel.at("rows").get<int>(),
                              {}});
      panel.at("colours").get_to(scene.panels.back().colours);
      const Panel& read = scene.panels.back();
      if (read.columns < 1 || read.rows < 1 ||
          read.colours.size() != static_cast<std::size_t>(read.columns) * static_cast<std::size_t>(read.rows))
        throw pfv::InputError(
            fmt::format("a panel of {} by {} fields has {} colours", read.columns, read.rows, read.colours.size()));
    }
    return scene;
  } catch (const Json::exception& error) {
    throw pfv::InputError(fmt::format("not a scene to draw: {}", error.what()));
  }
}

} // namespace studies
