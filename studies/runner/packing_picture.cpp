#include "studies/runner/packing_picture.hpp"

#include "studies/runner/colours.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace studies {

namespace {

using pfv::Vec3;

constexpr double width = 300, height = 300, margin = 12, bar_height = 44;
constexpr int shades = 16;

/// Onto the picture's plane; depth grows towards the eye.
struct View {
  Vec3 right, up, towards;

  View() {
    const double azimuth = -60 * std::numbers::pi / 180, elevation = 20 * std::numbers::pi / 180;
    towards =
        Vec3(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
    right = Vec3(-std::sin(azimuth), std::cos(azimuth), 0);
    up = towards.cross(right);
  }
};

Vec3 corner(const pfv::Box& box, int which) {
  return {(which & 1) != 0 ? box.upper.x() : box.lower.x(), (which & 2) != 0 ? box.upper.y() : box.lower.y(),
          (which & 4) != 0 ? box.upper.z() : box.lower.z()};
}

std::string gradients(std::string_view kind, const std::string& prefix) {
  std::string text;
  for (int i = 0; i < shades; ++i) {
    const Colour colour = kind.empty() ? Colour{130, 140, 150} : colour_of((i + 0.5) / shades);
    text += fmt::format("<radialGradient id=\"{}{}\" cx=\"0.4\" cy=\"0.35\" r=\"0.7\"><stop offset=\"0\" "
                        "stop-color=\"{}\"/><stop offset=\"0.5\" stop-color=\"{}\"/><stop offset=\"1\" "
                        "stop-color=\"{}\"/></radialGradient>\n",
                        prefix, i, lit(colour, 1.5), lit(colour, 1), lit(colour, 0.5));
    if (kind.empty())
      break;
  }
  return text;
}

std::string colour_bar(double most, const std::string& unit) {
  std::string text;
  const double step = (width - 2 * margin) / shades;
  for (int i = 0; i < shades; ++i)
    text += fmt::format("<rect x=\"{:.1f}\" y=\"{:.0f}\" width=\"{:.1f}\" height=\"9\" fill=\"{}\"/>\n",
                        margin + i * step, height + 8, step + 0.3, lit(colour_of((i + 0.5) / shades), 1));
  text += fmt::format("<g fill=\"currentColor\" font-size=\"12\"><text x=\"{0:.0f}\" y=\"{1:.0f}\">0</text><text "
                      "x=\"{2:.0f}\" y=\"{1:.0f}\" text-anchor=\"end\">{3:.3g} {4}</text></g>\n",
                      margin, height + 32, width - margin, most, unit);
  return text;
}

} // namespace

std::string packing_picture(const pfv::Packing& packing, std::span<const double> values, const std::string& unit,
                            const std::string& id_prefix) {
  const View view;
  std::array<double, 4> seen{1e300, -1e300, 1e300, -1e300}; // left, right, bottom, top
  const auto see = [&](const Vec3& point, double radius) {
    const double x = point.dot(view.right), y = point.dot(view.up);
    seen = {std::min(seen[0], x - radius), std::max(seen[1], x + radius), std::min(seen[2], y - radius),
            std::max(seen[3], y + radius)};
  };
  for (int i = 0; i < 8; ++i)
    see(corner(packing.box, i), 0);
  for (const pfv::Sphere& sphere : packing.spheres)
    see(sphere.centre, sphere.radius);
  const double scale =
      std::min((width - 2 * margin) / (seen[1] - seen[0]), (height - 2 * margin) / (seen[3] - seen[2]));
  const auto x = [&](const Vec3& p) { return width / 2 + scale * (p.dot(view.right) - (seen[0] + seen[1]) / 2); };
  const auto y = [&](const Vec3& p) { return height / 2 - scale * (p.dot(view.up) - (seen[2] + seen[3]) / 2); };

  // The corner nearest to the eye: its three edges are in front of all spheres, the others behind or beside.
  int nearest = 0;
  for (int i = 1; i < 8; ++i)
    if (corner(packing.box, i).dot(view.towards) > corner(packing.box, nearest).dot(view.towards))
      nearest = i;
  std::string behind, before;
  for (int i = 0; i < 8; ++i)
    for (const int along : {1, 2, 4})
      if ((i & along) == 0) {
        const Vec3 a = corner(packing.box, i), b = corner(packing.box, i | along);
        (i == nearest || (i | along) == nearest ? before : behind) +=
            fmt::format("M{:.1f},{:.1f}L{:.1f},{:.1f}", x(a), y(a), x(b), y(b));
      }

  std::vector<std::size_t> order(packing.spheres.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, [&](std::size_t i) { return packing.spheres[i].centre.dot(view.towards); });
  const double most = values.empty() ? 0 : std::ranges::max(values);
  std::string spheres;
  for (const std::size_t i : order) {
    const pfv::Sphere& sphere = packing.spheres[i];
    const int shade = most > 0 ? std::clamp(static_cast<int>(shades * values[i] / most), 0, shades - 1) : 0;
    spheres += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"url(#{}{})\"/>\n", x(sphere.centre),
                           y(sphere.centre), scale * sphere.radius, id_prefix, shade);
  }
  const bool coloured = most > 0;
  return fmt::format(
      "<svg role=\"img\" style=\"width:{0:.0f}px\" viewBox=\"0 0 {0:.0f} {1:.0f}\">\n<defs>\n{2}</defs>\n"
      "<path d=\"{3}\" fill=\"none\" stroke=\"currentColor\" stroke-opacity=\"0.6\"/>\n{4}"
      "<path d=\"{5}\" fill=\"none\" stroke=\"currentColor\" stroke-opacity=\"0.6\"/>\n{6}</svg>",
      width, height + (coloured ? bar_height : 0), gradients(coloured ? "coloured" : "", id_prefix), behind, spheres,
      before, coloured ? colour_bar(most, unit) : "");
}

} // namespace studies
