#include "studies/runner/read_study_case.hpp"

#include "reference/method.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <sstream>

namespace studies {

namespace {

using pfv::fail_at;

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

// Instead of those of the [[method]]s.
std::map<std::string, std::vector<double>> read_mesh_sizes(const toml::node& node,
                                                           const std::vector<std::string>& methods) {
  std::vector<std::string> valid;
  for (const std::string& name : methods)
    if (reference::find_method(name).convergence_order())
      valid.push_back(name);
  std::map<std::string, std::vector<double>> sizes;
  for (const auto& [key, list] : pfv::as_table(node, "mesh_sizes")) {
    const std::string name(key.str());
    if (std::ranges::find(valid, name) == valid.end())
      fail_at(list, fmt::format("mesh_sizes \"{}\" must be of a method with a mesh that the case asks: {}", name,
                                valid.empty() ? "it asks none" : fmt::format("{}", fmt::join(valid, ", "))));
    sizes[name] = as_mesh_sizes(list, "mesh_sizes");
  }
  return sizes;
}

StudyCase read_study_case(const toml::node& node, const std::filesystem::path& folder,
                          const std::vector<std::string>& all_methods, const Budget& budget) {
  const toml::table& table = pfv::as_table(node, "case");
  pfv::allow_keys(table, "[[case]]",
                  {"id", "label", "methods", "quick", "published", "curve", "seeds", "budget", "mesh_sizes", "packing",
                   "fluid", "flow", "faces", "buoyancy"});
  StudyCase one;
  one.id = as_id(pfv::required(table, "[[case]]", "id"));
  one.label = one.id;
  one.place = fmt::format("{}:{}", *table.source().path, table.source().begin.line);
  one.methods = all_methods;
  one.budget = budget;
  if_present(table, "label", [&](auto& label) { one.label = pfv::as_text(label, "label"); });
  if_present(table, "methods", [&](auto& list) { one.methods = as_some_of(list, "methods", all_methods); });
  if_present(table, "budget", [&](auto& own) { one.budget = as_budget(own, budget); });
  if_present(table, "mesh_sizes", [&](auto& own) { one.mesh_sizes = read_mesh_sizes(own, one.methods); });
  if_present(table, "quick", [&](const toml::node& quick) {
    if (const auto* flag = quick.as_boolean())
      one.quick_methods = flag->get() ? one.methods : std::vector<std::string>{};
    else
      one.quick_methods = as_some_of(quick, "quick", one.methods);
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

} // namespace

std::vector<StudyCase> read_study_cases(const toml::node& node, const std::filesystem::path& folder,
                                        const std::vector<std::string>& methods, const Budget& budget) {
  const StudyCase one = read_study_case(node, folder, methods, budget);
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

} // namespace studies
