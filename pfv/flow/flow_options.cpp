#include "pfv/flow/flow_options.hpp"

#include "pfv/flow/choice.hpp"
#include "pfv/problem/case.hpp"
#include "pfv/problem/toml_input.hpp"

namespace pfv {
namespace {

void choose_conductance(FlowOptions& options, std::string_view name) {
  options.conductance = choice_named<Conductance>("conductance", name);
}

void choose_walls(FlowOptions& options, std::string_view name) {
  options.walls = choice_named<WallRule>("walls", name);
}

void choose_solver(FlowOptions& options, std::string_view name) {
  options.solver = solver_named(name);
}

} // namespace

FlowOptions read_flow_options(const std::filesystem::path& question, const FlowOptionNames& said) {
  FlowOptions options;
  const toml::table root = is_case_file(question) ? read_toml(question) : toml::table{};
  const toml::node* node = root.get("pfv");
  const toml::table none;
  const toml::table& table = node ? as_table(*node, "pfv") : none;
  allow_keys(table, "[pfv]", {"conductance", "walls", "solver"});
  const auto choose = [&](const char* key, const std::optional<std::string>& name, auto set) {
    if (const toml::node* written = table.get(key)) {
      const std::string text = as_text(*written, key);
      located(*written, [&] { set(options, text); });
    }
    if (name)
      set(options, *name);
  };
  choose("conductance", said.conductance, choose_conductance);
  choose("walls", said.walls, choose_walls);
  choose("solver", said.solver, choose_solver);
  return options;
}

} // namespace pfv
