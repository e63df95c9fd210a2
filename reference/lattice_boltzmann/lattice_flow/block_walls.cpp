#include "reference/lattice_boltzmann/lattice_flow/block_walls.hpp"

namespace reference::lattice_boltzmann {

namespace {

Cell& neighbour(Block& block, const plb::Dot3D& at, const Step& step) {
  return block.get(at.x + step[0], at.y + step[1], at.z + step[2]);
}

} // namespace

void BlockWalls::add_faces(const FlowQuestion& question, Block& block, const Place& place) {
  for (std::size_t d = 1; d < directions; ++d) {
    Step mirrored = steps[d];
    Step across{};
    double sign = 1;
    for (std::size_t a = 0; a < 3; ++a) {
      const int source = place.voxel[a] - steps[d][a];
      if (question.beyond[a] == Beyond::repeats || (source >= 0 && source < question.voxels[a]))
        continue;
      mirrored[a] = -mirrored[a];
      across[a] = -steps[d][a];
      if (question.beyond[a] == Beyond::is_opposed)
        sign = -sign;
    }
    if (across == Step{})
      continue;
    auto& to = block.get(place.local.x, place.local.y, place.local.z)[static_cast<plb::plint>(d)];
    const auto& from = neighbour(block, place.local, across)[static_cast<plb::plint>(direction_of(mirrored))];
    reflections_.push_back({&to, &from, sign});
  }
}

void BlockWalls::add_link(const WallLink& link, std::size_t number, Block& block, const Place& place) {
  const auto out = static_cast<std::size_t>(link.direction);
  const auto back = opposite(out);
  const auto i_out = static_cast<plb::plint>(out);
  const auto i_back = static_cast<plb::plint>(back);
  Cell& here = block.get(place.local.x, place.local.y, place.local.z);
  const double weight = link.narrow ? 0 : (1 - 2 * link.fraction) / (1 + 2 * link.fraction);
  links_.push_back({&here[i_back], &neighbour(block, place.local, steps[out])[i_out], &here[i_out],
                    &neighbour(block, place.local, steps[back])[i_back], weight, number});
}

void BlockWalls::apply() const {
  for (const auto& [to, from, sign] : reflections_)
    *to = sign * *from;
  for (const Link& link : links_)
    *link.returned = *link.sent + link.weight * (*link.arrived - *link.left);
}

} // namespace reference::lattice_boltzmann
