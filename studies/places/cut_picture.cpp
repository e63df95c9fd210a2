#include "studies/places/cut_picture.hpp"

#include "pfv/flow/containing_pore.hpp"
#include "studies/runner/colours.hpp"
#include "studies/runner/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace studies {

namespace {

constexpr double width = 300;             // pixels
constexpr std::size_t points_across = 90; // at which the pore is looked up

/// The plane's own axes: across and along the flow; `normal` stands on it.
struct Plane {
  explicit Plane(const PlaceCase& viewed)
      : along(pfv::index(viewed.axis)), across((along + 1) % 3), normal((along + 2) % 3), box(viewed.network.box),
        scale(width / box.size()[across]), height(scale * box.size()[along]) {}

  double x(const pfv::Vec3& point) const { return scale * (point[across] - box.lower[across]); }
  double y(const pfv::Vec3& point) const { return height - scale * (point[along] - box.lower[along]); }
  pfv::Vec3 point(double x, double y) const {
    pfv::Vec3 point = (box.lower + box.upper) / 2;
    point[across] = box.lower[across] + x / scale;
    point[along] = box.lower[along] + (height - y) / scale;
    return point;
  }

  int along, across, normal;
  pfv::Box box;
  double scale, height; // pixels
};

/// The pores at points on a grid, line by line from above.
struct Section {
  explicit Section(const PlaceCase& of) : viewed(of), plane(of) {
    const int lines = static_cast<int>(std::ceil(plane.height / step));
    for (int line = 0; line < lines; ++line)
      for (std::size_t i = 0; i < points_across; ++i) {
        const double y = std::min((line + 0.5) * step, plane.height * (1 - 1e-9));
        pores.push_back(containing_pore(viewed.network, plane.point((static_cast<double>(i) + 0.5) * step, y)).pore);
      }
  }

  static constexpr double step = width / points_across;
  const PlaceCase& viewed;
  Plane plane;
  std::vector<int> pores;
};

/// Equal neighbours in a line are one rectangle; nothing where the colour is empty.
std::string rectangles(const Section& section, const std::vector<std::string>& colours) {
  const auto colour = [&](std::size_t point) { return colours[static_cast<std::size_t>(section.pores[point])]; };
  std::string text;
  for (std::size_t first = 0; first < section.pores.size(); first += points_across)
    for (std::size_t start = 0; start < points_across;) {
      std::size_t end = start + 1;
      while (end < points_across && colour(first + end) == colour(first + start))
        ++end;
      if (const std::string here = colour(first + start); !here.empty())
        text += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\"/>\n",
                            static_cast<double>(start) * Section::step,
                            static_cast<double>(first) / points_across * Section::step,
                            static_cast<double>(end - start) * Section::step + 0.3, Section::step + 0.3, here);
      start = end;
    }
  return text;
}

std::string grey_sections(const PlaceCase& viewed, const Plane& plane) {
  const double level = plane.point(0, 0)[plane.normal];
  std::string text;
  for (const pfv::Sphere& sphere : viewed.network.sites.spheres) { // images too
    const double above = sphere.centre[plane.normal] - level;
    const double square = sphere.radius * sphere.radius - above * above;
    if (square > 0)
      text += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"/>\n", plane.x(sphere.centre),
                          plane.y(sphere.centre), plane.scale * std::sqrt(square));
  }
  return text;
}

std::vector<std::string> colours(const std::vector<double>& values, const std::function<Colour(double)>& colour) {
  std::vector<std::string> texts;
  for (const double value : values)
    texts.push_back(std::isnan(value) ? "" : lit(colour(value), 1));
  return texts;
}

Figure cut(const Section& section, std::string caption, const std::vector<std::string>& colours) {
  Figure figure{std::move(caption), ""};
  figure.picture = fmt::format(
      "<svg role=\"img\" style=\"width:{0:.0f}px\" viewBox=\"0 0 {0:.0f} {1:.0f}\">\n"
      "<g shape-rendering=\"crispEdges\">\n{2}</g>\n"
      "<g fill=\"#8a8f96\" stroke=\"#5a5f66\">\n{3}</g>\n"
      "<rect width=\"{0:.0f}\" height=\"{1:.0f}\" fill=\"none\" stroke=\"currentColor\"/>\n</svg>",
      width, section.plane.height, rectangles(section, colours), grey_sections(section.viewed, section.plane));
  return figure;
}

} // namespace

const PlaceCase* shown_case(std::span<const PlaceCase> cases) {
  const auto random = std::ranges::find_if(
      cases, [](const PlaceCase& viewed) { return viewed.one.toml.find("random") != std::string::npos; });
  return random != cases.end() ? &*random : cases.empty() ? nullptr : &cases.front();
}

Shares reference_shares(const PlaceCase& viewed) {
  Shares shares{0, 0, {}};
  const auto pressures = viewed.pressures();
  if (pressures.empty())
    return shares;
  std::vector<double> known = pressures.front().reference;
  std::erase_if(known, [](double value) { return std::isnan(value); });
  const auto [least, most] = std::ranges::minmax(known);
  shares = {least, most, {}};
  for (const double pressure : pressures.front().reference)
    shares.of_pore.push_back((pressure - least) / (most - least));
  return shares;
}

std::vector<Figure> pressure_cuts(std::span<const PlaceCase> cases) {
  const PlaceCase* viewed = shown_case(cases);
  std::vector<Figure> figures;
  if (viewed == nullptr)
    return figures;
  const Section section(*viewed);
  const double drop = std::abs(viewed->rise);
  for (const PlacePairs& pairs : viewed->pressures()) {
    const std::size_t pores = pairs.values.size();
    if (figures.empty()) {
      const auto [least, most, shares] = reference_shares(*viewed);
      figures.push_back(
          cut(section,
              fmt::format("{}, {}: pressure in the pores, from dark at {} to bright at {} of the drop. "
                          "Blank: the centre of the pore lies in a sphere.",
                          viewed->one.label, viewed->reference.method, percent(least / drop), percent(most / drop)),
              colours(shares, colour_of)));
    }
    std::vector<double> differences(pores);
    double most = 0;
    for (std::size_t i = 0; i < pores; ++i)
      if (differences[i] = pairs.values[i] - pairs.reference[i]; !std::isnan(differences[i]))
        most = std::max(most, std::abs(differences[i]));
    for (double& difference : differences)
      difference /= most > 0 ? most : 1;
    figures.push_back(cut(section,
                          fmt::format("{} less {}, blue below, red above, the darkest {} of the drop.", pairs.method,
                                      viewed->reference.method, percent(most / drop)),
                          colours(differences, diverging_colour_of)));
  }
  return figures;
}

} // namespace studies
