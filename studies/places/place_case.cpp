#include "studies/places/place_case.hpp"

#include "pfv/problem/error.hpp"
#include "studies/runner/case_store.hpp"
#include "studies/runner/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace studies {

namespace {

using Field = std::vector<double>;
using Values = std::optional<BoundedField> Finding::*;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double resolved = 3; // times the error

void require_same(const PlaceCase& viewed, Values values, std::size_t here, const char* what) {
  const auto check = [&](const Finding& finding) {
    if (const auto& field = finding.*values; field && field->values.size() != here)
      throw pfv::InputError(fmt::format("{} of {} has {} {}, PFV makes {} now: run it again", finding.method,
                                        finding.case_id, field->values.size(), what, here));
  };
  check(viewed.reference);
  for (const Finding* other : viewed.others)
    check(*other);
}

/// Of every method that tells them, and the reference's beside them.
template <class Take>
std::vector<PlacePairs> pairs(const PlaceCase& viewed, Take take) {
  std::vector<PlacePairs> list;
  const std::optional<Field> reference = take(viewed.reference);
  if (!reference)
    return list;
  for (const Finding* other : viewed.others)
    if (std::optional<Field> values = take(*other))
      list.push_back({other->method, std::move(*values), *reference});
  return list;
}

/// The components along the flow of vectors written one after the other.
std::optional<Field> along_flow(const PlaceCase& viewed, const std::optional<BoundedField>& field) {
  if (!field)
    return std::nullopt;
  const auto axis = static_cast<std::size_t>(pfv::index(viewed.axis));
  const double sign = viewed.rise > 0 ? -1 : 1;
  Field along;
  for (std::size_t i = 0; i + 2 < field->values.size(); i += 3)
    along.push_back(sign * field->values[i + axis]);
  return along;
}

std::optional<Field> values_of(const std::optional<BoundedField>& field) {
  return field ? std::optional(field->values) : std::nullopt;
}

/// Pa, from pore i to pore j of every throat.
Field falls(const PlaceCase& viewed, const Field& pressures) {
  const auto& throats = viewed.network.throats;
  Field falls;
  for (std::size_t t = 0; t < throats.size(); ++t) {
    const double rise = throats.shift.empty() ? 0 : throats.shift[t][pfv::index(viewed.axis)] * viewed.rise;
    falls.push_back(pressures[static_cast<std::size_t>(throats.pores[t][0])] -
                    pressures[static_cast<std::size_t>(throats.pores[t][1])] - rise);
  }
  return falls;
}

bool tells_conductances(const Finding& finding) {
  return finding.pore_pressures && finding.throat_fluxes;
}

} // namespace

std::vector<PlacePairs> PlaceCase::pressures() const {
  return pairs(*this, [this](const Finding& finding) -> std::optional<Field> {
    if (finding.pore_pressures && reference.pore_pressures && (reference.free_level || finding.free_level))
      return at_level_of(*reference.pore_pressures, *finding.pore_pressures).values;
    return values_of(finding.pore_pressures);
  });
}

std::vector<PlacePairs> PlaceCase::forces() const {
  return pairs(*this, [this](const Finding& finding) { return along_flow(*this, finding.forces); });
}

std::vector<PlacePairs> PlaceCase::viscous_forces() const {
  return pairs(*this, [this](const Finding& finding) { return along_flow(*this, finding.viscous_forces); });
}

std::vector<PlacePairs> PlaceCase::fluxes() const {
  return pairs(*this, [](const Finding& finding) { return values_of(finding.throat_fluxes); });
}

std::vector<PlacePairs> PlaceCase::conductances() const {
  std::vector<PlacePairs> list;
  if (!tells_conductances(reference))
    return list;
  const Field &flux = reference.throat_fluxes->values, fall = falls(*this, reference.pore_pressures->values);
  const double flux_error = reference.throat_fluxes->error.value_or(0),
               fall_error = reference.pore_pressures->error.value_or(0) * std::sqrt(2);
  for (const Finding* other : others) {
    if (!tells_conductances(*other))
      continue;
    const Field own_fall = falls(*this, other->pore_pressures->values);
    PlacePairs pair{other->method, {}, {}};
    for (std::size_t t = 0; t < flux.size(); ++t) {
      const bool told = std::abs(flux[t]) > resolved * flux_error && std::abs(fall[t]) > resolved * fall_error;
      const auto ratio = [&](double q, double dp) { return told && q * dp > 0 ? q / dp : unknown; };
      pair.reference.push_back(ratio(flux[t], fall[t]));
      pair.values.push_back(ratio(other->throat_fluxes->values[t], own_fall[t]));
    }
    list.push_back(std::move(pair));
  }
  return list;
}

std::vector<PlaceCase> place_cases(const Study& study, std::span<const Result> results) {
  std::vector<PlaceCase> cases;
  for (const Result& result : results) {
    const Finding& reference = result.finding;
    if (reference.method != study.reference || !reference.answered())
      continue;
    const StudyCase& one = *std::ranges::find(study.cases, reference.case_id, &StudyCase::id);
    pfv::Case problem = problem_of(one);
    const auto setup = permeability_setup(problem);
    if (!setup || !setup->pressure_drop)
      continue;
    pfv::Clock clock;
    auto network = build_pore_network(problem.packing, periodic_axes(problem.faces), clock, true);
    PlaceCase viewed{one, std::move(problem), std::move(network), setup->axis, *setup->pressure_drop, reference, {}};
    for (const Result& other : results)
      if (other.finding.case_id == one.id && other.finding.method != study.reference && other.finding.answered())
        viewed.others.push_back(&other.finding);
    require_same(viewed, &Finding::pore_pressures, viewed.network.pores.size(), "pores");
    require_same(viewed, &Finding::throat_fluxes, viewed.network.throats.size(), "throats");
    cases.push_back(std::move(viewed));
  }
  return cases;
}

} // namespace studies
