#include "studies/places/cut_in_space.hpp"

#include "pfv/flow/containing_pore.hpp"
#include "studies/places/cut_picture.hpp"
#include "studies/render/render.hpp"
#include "studies/runner/colours.hpp"

#include <cmath>

namespace studies {

namespace {

constexpr int fields = 160; // of a panel, along its longer side

std::array<std::uint8_t, 3> bytes_of(double share) {
  if (std::isnan(share))
    return {200, 200, 200};
  const Colour colour = colour_of(share);
  return {static_cast<std::uint8_t>(colour.red), static_cast<std::uint8_t>(colour.green),
          static_cast<std::uint8_t>(colour.blue)};
}

Panel coloured(Panel panel, const pfv::PoreNetwork& network, const std::vector<double>& shares) {
  const double longer = std::max(panel.across.norm(), panel.up.norm());
  panel.columns = static_cast<int>(std::ceil(fields * panel.across.norm() / longer));
  panel.rows = static_cast<int>(std::ceil(fields * panel.up.norm() / longer));
  for (int row = 0; row < panel.rows; ++row)
    for (int column = 0; column < panel.columns; ++column) {
      const pfv::Vec3 point =
          panel.corner + (column + 0.5) / panel.columns * panel.across + (row + 0.5) / panel.rows * panel.up;
      panel.colours.push_back(bytes_of(shares[static_cast<std::size_t>(containing_pore(network, point).pore)]));
    }
  return panel;
}

} // namespace

RenderScene cut_in_space(const pfv::PoreNetwork& network, pfv::Axis axis, const std::vector<double>& shares) {
  const pfv::Box& box = network.box;
  const pfv::Vec3 size = box.size(), middle = (box.lower + box.upper) / 2;
  const int up = pfv::index(axis), first = (up + 1) % 3, second = (up + 2) % 3;
  const auto side = [&](int along, double length) {
    pfv::Vec3 vector = pfv::Vec3::Zero();
    vector[along] = length;
    return vector;
  };
  RenderScene scene{box, {box, box}, network.sites.spheres, {}, {}, side(up, 1)};
  scene.towards_eye[first] = 1;
  scene.towards_eye[second] = 0.75;
  scene.towards_eye[up] = 0.45;
  // Away goes what is above the middle of both axes.
  scene.pieces[0].upper[first] = middle[first];
  scene.pieces[1].lower[first] = middle[first];
  scene.pieces[1].upper[second] = middle[second];
  // A little behind the cut, so that the spheres' sections stand before them.
  const double back = 1e-4 * size.norm();
  pfv::Vec3 corner = middle;
  corner[up] = box.lower[up];
  scene.panels = {{corner - side(first, back), side(second, size[second] / 2), side(up, size[up])},
                  {corner - side(second, back), side(first, size[first] / 2), side(up, size[up])}};
  for (Panel& panel : scene.panels)
    panel = coloured(panel, network, shares);
  return scene;
}

std::vector<Figure> pressure_in_space(std::span<const PlaceCase> cases) {
  const PlaceCase* viewed = shown_case(cases);
  if (viewed == nullptr)
    return {};
  const Shares shares = reference_shares(*viewed);
  if (shares.of_pore.empty())
    return {};
  Rendering rendering = render(cut_in_space(viewed->network, viewed->axis, shares.of_pore));
  return {{"The same in space, a quarter of the box cut away, the flow's axis upwards.", "", std::move(rendering.png),
           std::move(rendering.why_not)}};
}

} // namespace studies
