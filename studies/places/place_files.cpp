#include "studies/places/place_files.hpp"

#include "studies/runner/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace studies {

namespace {

std::string number(double value) {
  return std::isnan(value) ? std::string() : fmt::format("{:.6g}", value);
}

/// Values by column of one quantity: the reference's, then those of the other methods, in the study's order.
class Columns {
public:
  Columns(const Study& study, std::string suffix) : suffix_(std::move(suffix)), names_{study.reference} {
    for (const StudyMethod& method : study.methods)
      if (method.name != study.reference)
        names_.push_back(method.name);
  }

  void add_heads(CsvRecord& record) const {
    for (const std::string& name : names_)
      record.push_back(name + suffix_);
  }

  void add_values(const std::vector<PlacePairs>& all, std::size_t place, CsvRecord& record) const {
    record.push_back(all.empty() ? "" : number(all.front().reference[place]));
    for (std::size_t m = 1; m < names_.size(); ++m) {
      const auto found = std::ranges::find(all, names_[m], &PlacePairs::method);
      record.push_back(found == all.end() ? "" : number(found->values[place]));
    }
  }

private:
  std::string suffix_;
  std::vector<std::string> names_;
};

void add_place(const pfv::Vec3& place, CsvRecord& record) {
  for (const double coordinate : place)
    record.push_back(number(coordinate));
}

std::string pores(std::span<const PlaceCase> cases, const Study& study) {
  const Columns pressures(study, "_pressure_pa");
  CsvRecord heads{"case", "pore", "x_m", "y_m", "z_m", "void_volume_m3"};
  pressures.add_heads(heads);
  std::string text = to_csv(heads);
  for (const PlaceCase& viewed : cases) {
    const auto all = viewed.pressures();
    for (std::size_t i = 0; i < viewed.network.pores.size(); ++i) {
      CsvRecord record{viewed.one.id, fmt::format("{}", i)};
      add_place(viewed.network.pores.centre[i], record);
      record.push_back(number(viewed.network.pores.void_volume[i]));
      pressures.add_values(all, i, record);
      text += to_csv(record);
    }
  }
  return text;
}

std::string spheres(std::span<const PlaceCase> cases, const Study& study) {
  const Columns forces(study, "_force_n"), shear(study, "_shear_n");
  CsvRecord heads{"case", "sphere", "x_m", "y_m", "z_m", "radius_m"};
  forces.add_heads(heads);
  shear.add_heads(heads);
  std::string text = to_csv(heads);
  for (const PlaceCase& viewed : cases) {
    const auto along = viewed.forces(), viscous = viewed.viscous_forces();
    const auto& list = viewed.problem.packing.spheres;
    for (std::size_t k = 0; k < list.size(); ++k) {
      CsvRecord record{viewed.one.id, fmt::format("{}", k)};
      add_place(list[k].centre, record);
      record.push_back(number(list[k].radius));
      forces.add_values(along, k, record);
      shear.add_values(viscous, k, record);
      text += to_csv(record);
    }
  }
  return text;
}

std::string throats(std::span<const PlaceCase> cases, const Study& study) {
  const Columns fluxes(study, "_flux_m3_s");
  CsvRecord heads{"case",          "throat",   "pore_i",         "pore_j",      "facet_area_m2",
                  "fluid_area_m2", "length_m", "void_volume_m3", "smallest_gap"};
  fluxes.add_heads(heads);
  std::string text = to_csv(heads);
  for (const PlaceCase& viewed : cases) {
    const auto all = viewed.fluxes();
    const auto& list = viewed.network.throats;
    for (std::size_t t = 0; t < list.size(); ++t) {
      CsvRecord record{viewed.one.id,
                       fmt::format("{}", t),
                       fmt::format("{}", list.pores[t][0]),
                       fmt::format("{}", list.pores[t][1]),
                       number(list.area[t]),
                       number(list.fluid_area[t]),
                       number(list.length[t]),
                       number(list.void_volume[t]),
                       number(list.gap[t])};
      fluxes.add_values(all, t, record);
      text += to_csv(record);
    }
  }
  return text;
}

} // namespace

std::map<std::string, std::string> place_files(std::span<const PlaceCase> cases, const Study& study) {
  std::map<std::string, std::string> files;
  for (const PlaceKind kind : study.places)
    switch (kind) {
    case PlaceKind::pores:
      files["pores.csv"] = pores(cases, study);
      break;
    case PlaceKind::spheres:
      files["spheres.csv"] = spheres(cases, study);
      break;
    case PlaceKind::throats:
      files["throats.csv"] = throats(cases, study);
      break;
    }
  return files;
}

} // namespace studies
