#include "studies/effect_cost/effect_study.hpp"

#include "pfv/problem/toml_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <map>
#include <sstream>

namespace studies {
namespace {

const toml::table& part(const toml::table& table, std::string_view place, std::string_view key) {
  return pfv::as_table(pfv::required(table, place, key), key);
}

std::size_t as_count(const toml::node& node, std::string_view key) {
  const auto value = pfv::as_integer(node, key);
  if (value < 1)
    pfv::fail_at(node, fmt::format("{} \"{}\" must be a whole number, 1 or more", key, value));
  return static_cast<std::size_t>(value);
}

std::size_t count(const toml::table& table, std::string_view key, std::size_t otherwise) {
  const toml::node* node = table.get(key);
  return node ? as_count(*node, key) : otherwise;
}

std::string text_of(const toml::table& table) {
  std::ostringstream text;
  text << table << '\n';
  return text.str();
}

/// The tables of `more` beside those of `scene`, instead of those of the same name.
toml::table joined(toml::table scene, const toml::table& more) {
  for (const auto& [key, node] : more)
    scene.insert_or_assign(key, node);
  return scene;
}

std::string as_id(const toml::node& node) {
  const std::string id = pfv::as_text(node, "id");
  const bool plain = std::ranges::all_of(id, [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; });
  if (id.empty() || !plain)
    pfv::fail_at(node, fmt::format("id \"{}\" must be made of letters, digits, _ and -", id));
  return id;
}

/// Numbers of [quick] where it has them.
struct Plan {
  toml::table of_all, quick;
  std::size_t operator()(std::string_view key, std::size_t otherwise) const {
    return count(quick, key, count(of_all, key, otherwise));
  }
};

Effect read_effect(const toml::node& node, const Plan& plan, const toml::table& of_all,
                   std::map<std::string, toml::table>& scenes) {
  const toml::table& table = pfv::as_table(node, "effect");
  pfv::allow_keys(table, "[[effect]]", {"id", "label", "beside", "steps", "adds"});
  Effect effect;
  const toml::node& id = pfv::required(table, "[[effect]]", "id");
  effect.id = effect.label = as_id(id);
  if (scenes.contains(effect.id))
    pfv::fail_at(id, fmt::format("id \"{}\" appears twice", effect.id));
  if (const toml::node* label = table.get("label"))
    effect.label = pfv::as_text(*label, "label");
  if (const toml::node* beside = table.get("beside")) {
    effect.beside = pfv::as_text(*beside, "beside");
    if (!scenes.contains(effect.beside))
      pfv::fail_at(*beside, fmt::format("beside \"{}\" must be the id of an effect above", effect.beside));
  }
  effect.steps = plan.quick.contains("steps") ? plan("steps", 1) : count(table, "steps", plan("steps", 1000));
  toml::table scene = effect.beside.empty() ? of_all : scenes.at(effect.beside);
  if (const toml::node* adds = table.get("adds"))
    scene = joined(std::move(scene), pfv::as_table(*adds, "adds"));
  effect.scene = text_of(scene);
  scenes.emplace(effect.id, std::move(scene));
  return effect;
}

} // namespace

bool is_effect_study(const std::filesystem::path& file) {
  return pfv::read_toml(file).contains("effect");
}

EffectStudy read_effect_study(const std::filesystem::path& file, bool quick) {
  const toml::table root = pfv::read_toml(file);
  pfv::allow_keys(root, "a study of effects", {"title", "question", "plan", "quick", "preparation", "scene", "effect"});
  EffectStudy study;
  study.folder = std::filesystem::absolute(file).parent_path();
  study.name = study.folder.filename().string();
  study.title = pfv::as_text(pfv::required(root, "the study", "title"), "title");
  study.question = pfv::as_text(pfv::required(root, "the study", "question"), "question");
  Plan plan{part(root, "the study", "plan"), quick ? part(root, "the study", "quick") : toml::table{}};
  pfv::allow_keys(plan.of_all, "[plan]", {"repeats", "warm_up", "steps", "preparation_steps"});
  pfv::allow_keys(plan.quick, "[quick]", {"repeats", "warm_up", "steps", "preparation_steps", "spheres"});
  study.repeats = static_cast<int>(plan("repeats", 5));
  study.warm_up = plan("warm_up", 50);
  study.preparation_steps = plan("preparation_steps", 1000);

  toml::table preparation = part(root, "the study", "preparation");
  if (const toml::node* spheres = plan.quick.get("spheres")) {
    toml::table packing = part(preparation, "[preparation]", "packing");
    packing.insert_or_assign("spheres", static_cast<std::int64_t>(as_count(*spheres, "spheres")));
    preparation.insert_or_assign("packing", packing);
  }
  study.preparation = text_of(preparation);

  const toml::array* effects = root.get_as<toml::array>("effect");
  if (!effects || effects->empty())
    pfv::fail_at(*root.get("effect"), "effect must be a list, [[effect]]");
  std::map<std::string, toml::table> scenes;
  for (const toml::node& node : *effects)
    study.effects.push_back(read_effect(node, plan, part(root, "the study", "scene"), scenes));
  return study;
}

} // namespace studies
