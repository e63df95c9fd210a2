#include "studies/runner/study_file.hpp"

#include "pfv/problem/toml_input.hpp"
#include "reference/method.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>

namespace studies {

namespace {

using pfv::fail_at;

template <class Read>
void if_present(const toml::table& table, std::string_view key, Read read) {
  if (const toml::node* node = table.get(key))
    read(*node);
}

double as_positive(const toml::node& node, std::string_view name) {
  const double value = pfv::as_number(node, name);
  if (!(value > 0) || !std::isfinite(value))
    fail_at(node, fmt::format("{} \"{}\" must be larger than zero", name, pfv::quote(node)));
  return value;
}

const toml::array& as_list(const toml::node& node, std::string_view name) {
  const toml::array* list = node.as_array();
  if (!list || list->empty())
    fail_at(node, fmt::format("{} \"{}\" must be a list with at least one entry", name, pfv::quote(node)));
  return *list;
}

std::vector<double> as_mesh_sizes(const toml::node& node, std::string_view name) {
  std::vector<double> sizes;
  for (const toml::node& size : as_list(node, name))
    sizes.push_back(as_positive(size, name));
  if (!std::ranges::is_sorted(sizes, std::ranges::greater_equal{}) || std::ranges::adjacent_find(sizes) != sizes.end())
    fail_at(node, fmt::format("{} \"{}\" must go from coarse to fine, each smaller than the one before", name,
                              pfv::quote(node)));
  return sizes;
}

std::string as_method(const toml::node& node) {
  const std::string name = pfv::as_text(node, "method");
  pfv::located(node, [&] { reference::find_method(name); });
  return name;
}

std::string as_one_of(const toml::node& node, std::string_view key, const std::vector<std::string>& valid) {
  const std::string name = pfv::as_text(node, key);
  if (std::ranges::find(valid, name) == valid.end())
    fail_at(node, fmt::format("{} \"{}\" must be one of {}", key, name, fmt::join(valid, ", ")));
  return name;
}

std::vector<std::string> as_methods_of(const toml::node& node, std::string_view key,
                                       const std::vector<std::string>& valid) {
  std::vector<std::string> names;
  for (const toml::node& entry : as_list(node, key))
    names.push_back(as_one_of(entry, key, valid));
  return names;
}

Budget read_budget(const toml::table& table) {
  pfv::allow_keys(table, "[budget]", {"cpu_seconds", "memory_bytes", "wall_seconds"});
  Budget budget;
  if_present(table, "cpu_seconds", [&](auto& node) { budget.cpu_seconds = as_positive(node, "cpu_seconds"); });
  if_present(table, "memory_bytes", [&](auto& node) { budget.memory_bytes = as_positive(node, "memory_bytes"); });
  if_present(table, "wall_seconds", [&](auto& node) { budget.wall_seconds = as_positive(node, "wall_seconds"); });
  return budget;
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
  if_present(table, "lines", [&](auto& node) { curve.lines = as_methods_of(node, "lines", methods); });
  if_present(table, "compared_with",
             [&](auto& node) { curve.compared_with = as_one_of(node, "compared_with", methods); });
  return curve;
}

int as_ranks(const toml::node& node, const std::string& method) {
  const auto ranks = node.value_exact<std::int64_t>();
  if (!ranks || *ranks < 1 || *ranks > 1024)
    fail_at(node, fmt::format("ranks \"{}\" must be a whole number from 1 to 1024", pfv::quote(node)));
  if (*ranks > 1 && !reference::find_method(method).runs_on_ranks())
    fail_at(node, fmt::format("ranks \"{}\" must be 1: {} does not share its work", *ranks, method));
  return static_cast<int>(*ranks);
}

StudyMethod read_method(const toml::node& node) {
  const toml::table& table = pfv::as_table(node, "method");
  pfv::allow_keys(table, "[[method]]", {"name", "mesh_sizes", "quick_mesh_sizes", "ranks"});
  StudyMethod method{as_method(pfv::required(table, "[[method]]", "name")), {1.4, 1.0}, {2.0, 1.4}};
  if_present(table, "mesh_sizes", [&](auto& sizes) { method.mesh_sizes = as_mesh_sizes(sizes, "mesh_sizes"); });
  if_present(table, "quick_mesh_sizes",
             [&](auto& sizes) { method.quick_mesh_sizes = as_mesh_sizes(sizes, "quick_mesh_sizes"); });
  if_present(table, "ranks", [&](auto& ranks) { method.ranks = as_ranks(ranks, method.name); });
  return method;
}

PublishedFigure read_published(const toml::node& node, const std::vector<std::string>& methods) {
  const toml::table& table = pfv::as_table(node, "published");
  pfv::allow_keys(table, "published", {"method", "unknowns", "cpu_seconds"});
  PublishedFigure figure;
  figure.method = as_one_of(pfv::required(table, "published", "method"), "method", methods);
  if_present(table, "unknowns", [&](auto& value) { figure.unknowns = as_positive(value, "unknowns"); });
  if_present(table, "cpu_seconds", [&](auto& value) { figure.cpu_seconds = as_positive(value, "cpu_seconds"); });
  return figure;
}

std::string as_id(const toml::node& node) {
  const std::string id = pfv::as_text(node, "id");
  const bool plain = std::ranges::all_of(id, [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; });
  if (id.empty() || !plain)
    fail_at(node, fmt::format("id \"{}\" must be made of letters, digits, _ and -", id));
  return id;
}

// The keys of a question, copied from the study into a case file of its own, with this seed if any. Its file names are
// relative to the study.
std::string question_of(const toml::table& table, const std::filesystem::path& folder,
                        std::optional<std::int64_t> seed = std::nullopt) {
  toml::table question;
  for (const char* key : {"packing", "fluid", "flow", "faces", "buoyancy"})
    if (const toml::node* node = table.get(key))
      question.insert(key, *node);
  if (auto* packing = question["packing"].as_table(); packing && packing->contains("file"))
    packing->insert_or_assign("file",
                              std::filesystem::absolute(folder / pfv::as_text(*packing->get("file"), "file")).string());
  if (auto* packing = question["packing"].as_table(); packing && seed)
    packing->insert_or_assign("seed", *seed);
  std::ostringstream text;
  text << question << '\n';
  return text.str();
}

StudyCase read_study_case(const toml::node& node, const std::filesystem::path& folder,
                          const std::vector<std::string>& all_methods) {
  const toml::table& table = pfv::as_table(node, "case");
  pfv::allow_keys(table, "[[case]]",
                  {"id", "label", "methods", "quick", "published", "curve", "seeds", "packing", "fluid", "flow",
                   "faces", "buoyancy"});
  StudyCase one;
  one.id = as_id(pfv::required(table, "[[case]]", "id"));
  one.label = one.id;
  one.place = fmt::format("{}:{}", *table.source().path, table.source().begin.line);
  one.methods = all_methods;
  if_present(table, "label", [&](auto& label) { one.label = pfv::as_text(label, "label"); });
  if_present(table, "methods", [&](auto& list) { one.methods = as_methods_of(list, "methods", all_methods); });
  if_present(table, "quick", [&](const toml::node& quick) {
    if (const auto* flag = quick.as_boolean())
      one.quick_methods = flag->get() ? one.methods : std::vector<std::string>{};
    else
      one.quick_methods = as_methods_of(quick, "quick", one.methods);
  });
  if_present(table, "published", [&](auto& list) {
    for (const toml::node& figure : as_list(list, "published"))
      one.published.push_back(read_published(figure, all_methods));
  });
  if_present(table, "curve", [&](auto& curve) { one.curve = pfv::as_text(curve, "curve"); });
  pfv::required(table, "[[case]]", "packing");
  one.toml = question_of(table, folder);
  return one;
}

// A case with seeds is as many cases, of one label.
std::vector<StudyCase> read_study_cases(const toml::node& node, const std::filesystem::path& folder,
                                        const std::vector<std::string>& all_methods) {
  const StudyCase one = read_study_case(node, folder, all_methods);
  const toml::table& table = *node.as_table();
  std::vector<StudyCase> cases;
  if_present(table, "seeds", [&](auto& list) {
    for (const toml::node& entry : as_list(list, "seeds")) {
      const auto seed = entry.template value_exact<std::int64_t>();
      if (!seed || *seed < 0)
        fail_at(entry, fmt::format("seeds \"{}\" must be whole numbers, 0 or more", pfv::quote(entry)));
      cases.push_back(one);
      cases.back().id += fmt::format("_{}", *seed);
      cases.back().toml = question_of(table, folder, seed);
    }
  });
  return cases.empty() ? std::vector{one} : cases;
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
                   "curve", "method", "case"});
  Study study;
  study.folder = std::filesystem::absolute(file).parent_path();
  study.name = study.folder.filename().string();
  study.title = pfv::as_text(pfv::required(root, "the study", "title"), "title");
  study.question = pfv::as_text(pfv::required(root, "the study", "question"), "question");
  if_present(root, "published_source",
             [&](auto& node) { study.published_source = pfv::as_text(node, "published_source"); });
  if_present(root, "tolerance",
             [&](auto& node) { study.tolerance = read_tolerance(pfv::as_table(node, "tolerance")); });
  if_present(root, "budget", [&](auto& node) { study.budget = read_budget(pfv::as_table(node, "budget")); });

  if_present(root, "samples", [&](auto& node) {
    const auto flag = node.template value_exact<bool>();
    if (!flag)
      fail_at(node, fmt::format("samples \"{}\" must be true or false", pfv::quote(node)));
    study.samples = *flag;
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

  const toml::node& cases = pfv::required(root, "the study", "case");
  for (const toml::node& node : as_list(cases, "case"))
    for (StudyCase& one : read_study_cases(node, file.parent_path(), names))
      study.cases.push_back(std::move(one));
  refuse_twice(cases, study.cases, &StudyCase::id, "case id");
  return study;
}

} // namespace studies
