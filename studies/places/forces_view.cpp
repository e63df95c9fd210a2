#include "studies/places/place_views.hpp"
#include "studies/places/scatter.hpp"
#include "studies/runner/compare.hpp"
#include "studies/runner/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace studies {

namespace {

using Places = std::vector<std::size_t>;

double sum(const std::vector<double>& values, const Places& places) {
  return std::accumulate(places.begin(), places.end(), 0.0, [&](double s, std::size_t i) { return s + values[i]; });
}

/// Of the sums over these spheres.
double bias(const PlacePairs& pairs, const Places& places) {
  return sum(pairs.values, places) / sum(pairs.reference, places) - 1;
}

double mean_force(const PlaceCase& viewed) {
  const auto all = viewed.forces();
  double sum = 0;
  for (const double force : all.front().reference)
    sum += force;
  return sum / static_cast<double>(all.front().reference.size());
}

/// Spheres by radius: a third of them in each; one group where all are equal.
std::vector<Places> by_size(const PlaceCase& viewed) {
  const auto& spheres = viewed.problem.packing.spheres;
  Places order(spheres.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return spheres[i].radius; });
  if (spheres[order.front()].radius == spheres[order.back()].radius || order.size() < 3)
    return {order};
  std::vector<Places> groups(3);
  for (std::size_t i = 0; i < order.size(); ++i)
    groups[3 * i / order.size()].push_back(order[i]);
  return groups;
}

/// Between spheres and faces forces are bound by the balance of the whole box, so a bias in all is small by
/// construction where walls bear no shear.
Table table(std::span<const PlaceCase> cases) {
  Table table{{{"case"},
               {"method"},
               {"spheres", true},
               {"rms", true},
               {"reference ±", true},
               {"bias", true},
               {"small third", true},
               {"middle third", true},
               {"large third", true}},
              {}};
  for (const PlaceCase& viewed : cases)
    for (const PlacePairs& pairs : viewed.forces()) {
      const auto groups = by_size(viewed);
      const auto& field = *viewed.reference.forces;
      const auto other =
          std::ranges::find(viewed.others, pairs.method, [](const Finding* finding) { return finding->method; });
      const double unit = rms(field.values);
      Places all(pairs.values.size());
      std::iota(all.begin(), all.end(), 0);
      const auto third = [&](std::size_t i) { return groups.size() == 3 ? percent(bias(pairs, groups[i])) : ""; };
      table.rows.push_back({viewed.one.label, pairs.method, fmt::format("{}", pairs.values.size()),
                            percent(rms_difference((*other)->forces->values, field.values) / unit),
                            field.error ? percent(*field.error / unit) : "", percent(bias(pairs, all)), third(0),
                            third(1), third(2)});
    }
  return table;
}

Table shear_table(std::span<const PlaceCase> cases) {
  Table table{{{"case"}, {"method"}, {"share of shear", true}, {"of the reference", true}, {"rms", true}}, {}};
  for (const PlaceCase& viewed : cases) {
    const auto all = viewed.forces();
    for (const PlacePairs& shear : viewed.viscous_forces()) {
      const auto whole = std::ranges::find(all, shear.method, &PlacePairs::method);
      if (whole == all.end())
        continue;
      Places places(shear.values.size());
      std::iota(places.begin(), places.end(), 0);
      table.rows.push_back({viewed.one.label, shear.method,
                            percent(sum(shear.values, places) / sum(whole->values, places)),
                            percent(sum(shear.reference, places) / sum(whole->reference, places)),
                            percent(rms_difference(shear.values, shear.reference) / rms(shear.reference))});
    }
  }
  return table;
}

} // namespace

void add_forces(std::span<const PlaceCase> cases, const Study& study, Document& page) {
  Table differences = table(cases);
  if (differences.rows.empty())
    return;
  page.add(Heading{"Forces on spheres"});
  page.add(Paragraph{"*Rms*: of the difference of the force vectors, over the rms force. *Bias*: of the sum of the "
                     "forces along the flow, over all spheres and over thirds of them by radius. The sum over all is "
                     "bound by the balance of the whole box, so its bias is small by construction where walls bear no "
                     "shear; how it is shared out is not."});
  page.add(std::move(differences));
  page.add(scatter(
      cases, study, "force / mean force", "Force along the flow on every sphere, all cases.",
      [](const PlaceCase& viewed) { return viewed.forces(); }, mean_force));
  Table shear = shear_table(cases);
  if (shear.rows.empty())
    return;
  page.add(Heading{"Shear", 3});
  page.add(Paragraph{"The part of the force along the flow that the shear on the surface has, the pressure the rest. "
                     "*Rms*: of the difference of the shear forces, over their own rms."});
  page.add(std::move(shear));
  page.add(scatter(
      cases, study, "shear force / mean force", "Shear's part of the force along the flow on every sphere, all cases.",
      [](const PlaceCase& viewed) { return viewed.viscous_forces(); }, mean_force));
}

} // namespace studies
