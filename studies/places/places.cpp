#include "studies/places/places.hpp"

#include "studies/places/place_files.hpp"
#include "studies/places/place_views.hpp"

namespace studies {

void add_places(const Study& study, std::span<const Result> results, Document& page) {
  if (study.places.empty())
    return;
  const std::vector<PlaceCase> cases = place_cases(study, results);
  for (const PlaceKind kind : study.places)
    switch (kind) {
    case PlaceKind::pores:
      add_pressures(cases, study, page);
      break;
    case PlaceKind::spheres:
      add_forces(cases, study, page);
      break;
    case PlaceKind::throats:
      add_throats(cases, study, page);
      break;
    }
}

std::map<std::string, std::string> place_files(const Study& study, std::span<const Result> results) {
  if (study.places.empty())
    return {};
  return place_files(std::span<const PlaceCase>(place_cases(study, results)), study);
}

} // namespace studies
