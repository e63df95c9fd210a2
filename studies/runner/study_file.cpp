#include "studies/runner/study_file.hpp"

#include "reference/method.hpp"
#include "studies/runner/read_study_case.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace studies {

namespace {

using pfv::fail_at;

std::string as_method(const toml::node& node) {
  const std::string name = pfv::as_text(node, "method");
  pfv::located(node, [&] { reference::find_method(name); });
  return name;
}

Tolerance read_tolerance(const toml::table& table) {
  pfv::allow_keys(table, "[tolerance]", {"permeability", "forces", "pressures"});
  Tolerance tolerance;
  if_present(table, "permeability", [&](auto& node) { tolerance.permeability = as_positive(node, "permeability"); });
  if_present(table, "forces", [&](auto& node) { tolerance.forces = as_positive(node, "forces"); });
  if_present(table, "pressures", [&](auto& node) { tolerance.pressures = as_positive(node, "pressures"); });
  return tolerance;
}

Scaling read_scaling(const toml::table& table, const std::vector<std::string>& methods) {
  pfv::allow_keys(table, "[scaling]", {"compared_with", "unit_stage"});
  Scaling scaling;
  if_present(table, "compared_with",
             [&](auto& node) { scaling.compared_with = as_one_of(node, "compared_with", methods); });
  if_present(table, "unit_stage", [&](auto& node) { scaling.unit_stage = pfv::as_text(node, "unit_stage"); });
  return scaling;
}

Curve read_curve(const toml::table& table, const std::vector<std::string>& methods) {
  pfv::allow_keys(table, "[curve]", {"lines", "compared_with"});
  Curve curve;
  if_present(table, "lines", [&](auto& node) { curve.lines = as_some_of(node, "lines", methods); });
  if_present(table, "compared_with",
             [&](auto& node) { curve.compared_with = as_one_of(node, "compared_with", methods); });
  return curve;
}

Accuracy read_accuracy(const toml::table& table) {
  pfv::allow_keys(table, "[accuracy]", {"levels"});
  return {as_mesh_sizes(pfv::required(table, "[accuracy]", "levels"), "levels")};
}

std::vector<PlaceKind> as_places(const toml::node& node) {
  std::vector<PlaceKind> kinds;
  for (const std::string& name : as_some_of(node, "places", {"pores", "spheres", "throats"}))
    kinds.push_back(name == "pores" ? PlaceKind::pores : name == "spheres" ? PlaceKind::spheres : PlaceKind::throats);
  return kinds;
}

int as_ranks(const toml::node& node, const std::string& method) {
  const auto ranks = node.value_exact<std::int64_t>();
  if (!ranks || *ranks < 1 || *ranks > 1024)
    fail_at(node, fmt::format("ranks \"{}\" must be a whole number from 1 to 1024", pfv::quote(node)));
  if (*ranks > 1 && !reference::find_method(method).runs_on_ranks())
    fail_at(node, fmt::format("ranks \"{}\" must be 1: {} does not share its work", *ranks, method));
  return static_cast<int>(*ranks);
}

bool as_flag(const toml::node& node, std::string_view key) {
  const auto flag = node.value_exact<bool>();
  if (!flag)
    fail_at(node, fmt::format("{} \"{}\" must be true or false", key, pfv::quote(node)));
  return *flag;
}

StudyMethod read_method(const toml::node& node) {
  const toml::table& table = pfv::as_table(node, "method");
  pfv::allow_keys(table, "[[method]]", {"name", "mesh_sizes", "quick_mesh_sizes", "ranks", "may_fail"});
  StudyMethod method{as_method(pfv::required(table, "[[method]]", "name")), {1.4, 1.0}, {2.0, 1.4}};
  if_present(table, "mesh_sizes", [&](auto& sizes) { method.mesh_sizes = as_mesh_sizes(sizes, "mesh_sizes"); });
  if_present(table, "quick_mesh_sizes",
             [&](auto& sizes) { method.quick_mesh_sizes = as_mesh_sizes(sizes, "quick_mesh_sizes"); });
  if_present(table, "ranks", [&](auto& ranks) { method.ranks = as_ranks(ranks, method.name); });
  if_present(table, "may_fail", [&](auto& flag) { method.may_fail = as_flag(flag, "may_fail"); });
  return method;
}

template <class List>
void refuse_twice(const toml::node& node, const List& list, std::string List::value_type::*name, const char* what) {
  std::vector<std::string> names;
  for (const auto& one : list) {
    if (std::ranges::find(names, one.*name) != names.end())
      fail_at(node, fmt::format("{} \"{}\" appears twice", what, one.*name));
    names.push_back(one.*name);
  }
}

} // namespace

Study read_study(const std::filesystem::path& file) {
  const toml::table root = pfv::read_toml(file);
  pfv::allow_keys(root, "a study",
                  {"title", "question", "reference", "published_source", "tolerance", "budget", "samples", "scaling",
                   "curve", "accuracy", "places", "method", "case"});
  Study study;
  study.folder = std::filesystem::absolute(file).parent_path();
  study.name = study.folder.filename().string();
  study.title = pfv::as_text(pfv::required(root, "the study", "title"), "title");
  study.question = pfv::as_text(pfv::required(root, "the study", "question"), "question");
  if_present(root, "published_source",
             [&](auto& node) { study.published_source = pfv::as_text(node, "published_source"); });
  if_present(root, "tolerance",
             [&](auto& node) { study.tolerance = read_tolerance(pfv::as_table(node, "tolerance")); });

  if_present(root, "samples", [&](auto& node) { study.samples = as_flag(node, "samples"); });
  if_present(root, "places", [&](auto& node) {
    study.places = as_places(node);
    study.samples = true;
  });

  const toml::node& methods = pfv::required(root, "the study", "method");
  std::vector<std::string> names;
  for (const toml::node& node : as_list(methods, "method")) {
    study.methods.push_back(read_method(node));
    names.push_back(study.methods.back().name);
  }
  refuse_twice(methods, study.methods, &StudyMethod::name, "method");
  study.reference = as_one_of(pfv::required(root, "the study", "reference"), "reference", names);

  if_present(root, "scaling", [&](auto& node) { study.scaling = read_scaling(pfv::as_table(node, "scaling"), names); });

  if_present(root, "curve", [&](auto& node) { study.curve = read_curve(pfv::as_table(node, "curve"), names); });

  if_present(root, "accuracy", [&](auto& node) { study.accuracy = read_accuracy(pfv::as_table(node, "accuracy")); });

  Budget budget;
  if_present(root, "budget", [&](auto& node) { budget = as_budget(node, budget); });
  const toml::node& cases = pfv::required(root, "the study", "case");
  for (const toml::node& node : as_list(cases, "case"))
    for (StudyCase& one : read_study_cases(node, file.parent_path(), names, budget))
      study.cases.push_back(std::move(one));
  refuse_twice(cases, study.cases, &StudyCase::id, "case id");
  return study;
}

} // namespace studies
