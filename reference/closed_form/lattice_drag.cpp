#include "reference/closed_form/lattice_drag.hpp"

#include <array>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace reference {

extern const char* const lattice_drag_csv;

namespace {

pfv::Lattice lattice_named(const std::string& name) {
  if (name == "sc")
    return pfv::Lattice::simple_cubic;
  if (name == "bcc")
    return pfv::Lattice::bcc;
  if (name == "fcc")
    return pfv::Lattice::fcc;
  throw std::logic_error("lattice_drag.csv: unknown lattice '" + name + "'");
}

// Half a unit of the last digit printed by Zick & Homsy, who give three or four.
double rounding_error(const std::string& printed) {
  const auto point = printed.find('.');
  const auto decimals = point == std::string::npos ? 0 : printed.size() - point - 1;
  return 0.5 * std::pow(10.0, -static_cast<double>(decimals)) / std::stod(printed);
}

LatticeDrag parse(const std::string& line) {
  std::istringstream in(line);
  std::array<std::string, 4> cells;
  for (std::string& cell : cells)
    std::getline(in, cell, ',');
  const auto& [lattice, fraction, zick_homsy, fundamental] = cells;
  LatticeDrag row{lattice_named(lattice), std::stod(fraction), 0, 0};
  if (fundamental.empty()) {
    row.coefficient = std::stod(zick_homsy);
    row.relative_error = rounding_error(zick_homsy);
  } else {
    row.coefficient = std::stod(fundamental);
    row.relative_error = row.solid_fraction <= 0.5 ? 6e-5 : 5e-4;
  }
  return row;
}

std::vector<LatticeDrag> parse_table() {
  std::vector<LatticeDrag> table;
  std::istringstream in(lattice_drag_csv);
  for (std::string line; std::getline(in, line);)
    if (!line.empty() && line[0] != '#' && !line.starts_with("lattice,"))
      table.push_back(parse(line));
  return table;
}

} // namespace

const std::vector<LatticeDrag>& lattice_drag_table() {
  static const auto table = parse_table();
  return table;
}

std::optional<LatticeDrag> lattice_drag(pfv::Lattice lattice, double solid_fraction) {
  for (const LatticeDrag& row : lattice_drag_table())
    if (row.lattice == lattice && std::abs(solid_fraction / row.solid_fraction - 1) < 1e-6)
      return row;
  return std::nullopt;
}

} // namespace reference
