#include "reference/lattice_boltzmann/pockets.hpp"

#include "pfv/problem/error.hpp"
#include "reference/lattice_boltzmann/velocities.hpp"

#include <algorithm>
#include <numeric>
#include <set>

namespace reference::lattice_boltzmann {

namespace {

using Voxel = std::array<int, 3>;

/// Sets of voxels that grow together: each knows another of its set, down to one that knows itself.
class Sets {
public:
  explicit Sets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), std::uint32_t{0}); }
  std::uint32_t of(std::size_t i) {
    while (parent_[i] != i)
      i = parent_[i] = parent_[parent_[i]];
    return static_cast<std::uint32_t>(i);
  }
  void join(std::size_t i, std::size_t j) { parent_[of(i)] = of(j); }

private:
  std::vector<std::uint32_t> parent_;
};

template <typename Visit>
void visit_fluid(const Voxels& voxels, Visit visit) {
  for (int x = 0; x < voxels.size()[0]; ++x)
    for (int y = 0; y < voxels.size()[1]; ++y)
      for (int z = 0; z < voxels.size()[2]; ++z)
        if (const Voxel voxel{x, y, z}; voxels.is_fluid(voxel))
          visit(voxel);
}

// Joins fluid voxels one step apart; those across the ends of the axis only when asked, and then only those.
void join_neighbours(Sets& sets, const Voxels& voxels, std::size_t axis, bool across_ends) {
  visit_fluid(voxels, [&](const Voxel& voxel) {
    for (std::size_t d = 1; d <= pairs; ++d) {
      Voxel next = voxel;
      for (std::size_t a = 0; a < 3; ++a)
        next[a] += steps[d][a];
      const bool leaves = next[axis] < 0 || next[axis] >= voxels.size()[axis];
      if (leaves != across_ends)
        continue;
      next = voxels.image(next);
      if (voxels.is_fluid(next))
        sets.join(voxels.index(voxel), voxels.index(next));
    }
  });
}

std::int32_t nearest_sphere(const std::vector<SphereImage>& images, const Voxel& voxel) {
  const pfv::Vec3 centre(voxel[0] + 0.5, voxel[1] + 0.5, voxel[2] + 0.5);
  return std::ranges::min(images, {},
                          [&](const SphereImage& image) { return (image.centre - centre).norm() - image.radius; })
      .sphere;
}

} // namespace

std::size_t fill_pockets(const FlowQuestion& question, Voxels& voxels) {
  const auto axis = static_cast<std::size_t>(question.axis);
  const auto& n = voxels.size();
  Sets sets(voxels.index({n[0] - 1, n[1] - 1, n[2] - 1}) + 1);
  join_neighbours(sets, voxels, axis, false);
  std::set<std::uint32_t> at_lower;
  std::set<std::size_t> ways;
  visit_fluid(voxels, [&](const Voxel& voxel) {
    if (voxel[axis] == 0)
      at_lower.insert(sets.of(voxels.index(voxel)));
  });
  visit_fluid(voxels, [&](const Voxel& voxel) {
    if (const auto set = sets.of(voxels.index(voxel)); voxel[axis] == n[axis] - 1 && at_lower.contains(set))
      ways.insert(set);
  });
  if (ways.empty())
    throw pfv::SolveError("no way through the voxels of the void from one end of the box to the other");
  join_neighbours(sets, voxels, axis, true);
  std::set<std::uint32_t> open;
  for (const std::size_t way : ways)
    open.insert(sets.of(way));

  const auto images = sphere_images(question);
  std::vector<Voxel> pockets;
  visit_fluid(voxels, [&](const Voxel& voxel) {
    if (!open.contains(sets.of(voxels.index(voxel))))
      pockets.push_back(voxel);
  });
  for (const Voxel& pocket : pockets)
    voxels.give(pocket, nearest_sphere(images, pocket));
  return pockets.size();
}

} // namespace reference::lattice_boltzmann
