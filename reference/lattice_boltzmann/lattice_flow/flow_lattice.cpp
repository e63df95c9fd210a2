#include "reference/lattice_boltzmann/lattice_flow/flow_lattice.hpp"

#include "reference/lattice_boltzmann/lattice_flow/all_ranks.hpp"
#include "reference/lattice_boltzmann/lattice_flow/block_walls.hpp"

#include <map>
#include <numeric>

namespace reference::lattice_boltzmann {

namespace {

using WallsOfBlocks = std::map<const Block*, BlockWalls>;

/// Puts a block's walls right after streaming, before Palabos hands its rim to other blocks.
class WallProcessor final : public plb::BoxProcessingFunctional3D_L<double, plb::descriptors::D3Q19Descriptor> {
public:
  explicit WallProcessor(const WallsOfBlocks& walls) : walls_(&walls) {}
  void process(plb::Box3D, Block& block) override { walls_->at(&block).apply(); }
  WallProcessor* clone() const override { return new WallProcessor(*this); }
  void getTypeOfModification(std::vector<plb::modif::ModifT>& modified) const override {
    modified[0] = plb::modif::staticVariables;
  }

private:
  const WallsOfBlocks* walls_;
};

StokesCollision collision_of(const FlowQuestion& question) {
  StokesCollision::Vector force{};
  force[static_cast<std::size_t>(question.axis)] = 1;
  return {question.viscosity, question.magic, force};
}

// One layer beyond each face that is not periodic; periodic ones are Palabos' own.
int layer(const FlowQuestion& question, std::size_t axis) {
  return question.beyond[axis] == Beyond::repeats ? 0 : 1;
}

int cells(const FlowQuestion& question, std::size_t axis) {
  return question.voxels[axis] + 2 * layer(question, axis);
}

} // namespace

struct FlowLattice::Blocks {
  const FlowQuestion& question;
  const Voxels& voxels;
  const std::vector<WallLink>& links;
  StokesCollision collision;
  Lattice lattice;
  WallsOfBlocks walls;

  Blocks(const FlowQuestion& question_, const Voxels& voxels_, const std::vector<WallLink>& links_)
      : question(question_), voxels(voxels_), links(links_), collision(collision_of(question_)),
        lattice(cells(question_, 0), cells(question_, 1), cells(question_, 2), new StokesDynamics(collision)) {
    for (std::size_t a = 0; a < 3; ++a)
      lattice.periodicity().toggle(static_cast<plb::plint>(a), question.beyond[a] == Beyond::repeats);
    lattice.toggleInternalStatistics(false);
    for (const plb::plint id : lattice.getLocalInfo().getBlocks())
      prepare(lattice.getComponent(id));
    visit_fluid([&](Block& block, const BlockWalls::Place& place) {
      walls[&block].add_faces(question, block, place);
      add_links(block, place);
    });
    plb::integrateProcessingFunctional(new WallProcessor(walls), lattice.getBoundingBox(), lattice, 0);
  }

  std::array<int, 3> voxel_at(const Block& block, plb::plint x, plb::plint y, plb::plint z) const {
    const plb::Dot3D corner = block.getLocation();
    return {static_cast<int>(corner.x + x) - layer(question, 0), static_cast<int>(corner.y + y) - layer(question, 1),
            static_cast<int>(corner.z + z) - layer(question, 2)};
  }

  bool in_box(const std::array<int, 3>& voxel) const {
    for (std::size_t a = 0; a < 3; ++a)
      if (question.beyond[a] != Beyond::repeats && (voxel[a] < 0 || voxel[a] >= question.voxels[a]))
        return false;
    return true;
  }

  // The rim of a block, which repeats cells of its neighbours, collides like them.
  void prepare(Block& block) {
    walls[&block];
    for (plb::plint x = 0; x < block.getNx(); ++x)
      for (plb::plint y = 0; y < block.getNy(); ++y)
        for (plb::plint z = 0; z < block.getNz(); ++z) {
          const auto voxel = voxel_at(block, x, y, z);
          const bool is_fluid = in_box(voxel) && voxels.is_fluid(voxels.image(voxel));
          block.attributeDynamics(x, y, z, is_fluid ? &block.getBackgroundDynamics() : new Solid);
          for (std::size_t d = 0; d < directions; ++d)
            block.get(x, y, z)[static_cast<plb::plint>(d)] = is_fluid ? collision.at_rest(d) : 0;
        }
  }

  void add_links(Block& block, const BlockWalls::Place& place) {
    const auto first = std::ranges::lower_bound(links, voxels.index(place.voxel), {},
                                                [&](const WallLink& link) { return voxels.index(link.voxel); });
    for (auto link = first; link != links.end() && link->voxel == place.voxel; ++link)
      walls[&block].add_link(*link, static_cast<std::size_t>(link - links.begin()), block, place);
  }

  /// Calls visit(block, place) for the fluid voxels of this rank.
  template <typename Visit>
  void visit_fluid(Visit visit) {
    for (const plb::plint id : lattice.getLocalInfo().getBlocks()) {
      Block& block = lattice.getComponent(id);
      const plb::SmartBulk3D bulk(lattice.getMultiBlockManagement(), id);
      const plb::Box3D own = bulk.toLocal(bulk.getBulk());
      for (plb::plint x = own.x0; x <= own.x1; ++x)
        for (plb::plint y = own.y0; y <= own.y1; ++y)
          for (plb::plint z = own.z0; z <= own.z1; ++z) {
            const auto voxel = voxel_at(block, x, y, z);
            if (voxels.inside(voxel) && voxels.is_fluid(voxel))
              visit(block, BlockWalls::Place{voxel, {x, y, z}});
          }
    }
  }

  // f*_d and f_-d of a link hand over (f*_d + f_-d) c_d.
  template <typename Visit>
  void visit_momenta(Visit visit) const {
    for (const auto& [block, block_walls] : walls)
      block_walls.visit_links([&](std::size_t number, double sent, double returned) {
        const WallLink& link = links[number];
        const Step& step = steps[static_cast<std::size_t>(link.direction)];
        const double p = sent + returned;
        visit(link, std::array<double, 3>{p * step[0], p * step[1], p * step[2]});
      });
  }
};

FlowLattice::FlowLattice(const FlowQuestion& question, const Voxels& voxels, const std::vector<WallLink>& links)
    : blocks_(std::make_unique<Blocks>(question, voxels, links)) {}

FlowLattice::~FlowLattice() = default;

void FlowLattice::step() {
  blocks_->lattice.collideAndStream();
}

FlowState FlowLattice::state() const {
  const auto& question = blocks_->question;
  const auto axis = static_cast<std::size_t>(question.axis);
  FlowState state;
  state.section_velocity.assign(static_cast<std::size_t>(question.voxels[axis]), 0);
  blocks_->visit_fluid([&](Block& block, const BlockWalls::Place& place) {
    const Cell& cell = block.get(place.local.x, place.local.y, place.local.z);
    state.section_velocity[static_cast<std::size_t>(place.voxel[axis])] += blocks_->collision.velocity(cell)[axis];
  });
  std::vector<double> momentum{0};
  blocks_->visit_momenta([&](const WallLink&, const std::array<double, 3>& p) { momentum[0] += p[axis]; });
  sum_over_ranks(state.section_velocity);
  sum_over_ranks(momentum);
  const auto& n = question.voxels;
  const double section = static_cast<double>(n[0]) * n[1] * n[2] / n[axis];
  for (double& velocity : state.section_velocity)
    velocity /= section;
  state.velocity = std::reduce(state.section_velocity.begin(), state.section_velocity.end()) / n[axis];
  state.taken_up = momentum[0] / static_cast<double>(blocks_->voxels.fluid_count());
  return state;
}

void FlowLattice::centre_pressure() {
  std::vector<double> mean{0};
  const auto cell_at = [](Block& block, const BlockWalls::Place& place) -> Cell& {
    return block.get(place.local.x, place.local.y, place.local.z);
  };
  blocks_->visit_fluid([&](Block& block, const BlockWalls::Place& place) {
    mean[0] += StokesCollision::density(cell_at(block, place));
  });
  sum_over_ranks(mean);
  mean[0] /= static_cast<double>(blocks_->voxels.fluid_count());
  for (const plb::plint id : blocks_->lattice.getLocalInfo().getBlocks()) {
    Block& block = blocks_->lattice.getComponent(id);
    for (plb::plint x = 0; x < block.getNx(); ++x)
      for (plb::plint y = 0; y < block.getNy(); ++y)
        for (plb::plint z = 0; z < block.getNz(); ++z)
          for (std::size_t d = 0; d < directions; ++d)
            block.get(x, y, z)[static_cast<plb::plint>(d)] -= weight(d) * mean[0];
  }
}

std::vector<pfv::Vec3> FlowLattice::forces() const {
  std::vector<double> sums(3 * blocks_->question.spheres.size(), 0);
  blocks_->visit_momenta([&](const WallLink& link, const std::array<double, 3>& p) {
    const auto own = on_sphere_inside(blocks_->question, link, p);
    for (std::size_t a = 0; a < 3; ++a)
      sums[3 * static_cast<std::size_t>(link.sphere) + a] += own[a];
  });
  sum_over_ranks(sums);
  std::vector<pfv::Vec3> forces;
  for (std::size_t k = 0; k < sums.size(); k += 3)
    forces.emplace_back(sums[k], sums[k + 1], sums[k + 2]);
  return forces;
}

Fields FlowLattice::fields() const {
  const auto& n = blocks_->question.voxels;
  const auto count = blocks_->voxels.index({n[0] - 1, n[1] - 1, n[2] - 1}) + 1;
  Fields fields;
  fields.pressure.assign(count, 0);
  fields.velocity.fill(std::vector<double>(count, 0));
  blocks_->visit_fluid([&](Block& block, const BlockWalls::Place& place) {
    const Cell& cell = block.get(place.local.x, place.local.y, place.local.z);
    const auto at = blocks_->voxels.index(place.voxel);
    const auto u = blocks_->collision.velocity(cell);
    fields.pressure[at] = StokesCollision::density(cell) / 3;
    for (std::size_t a = 0; a < 3; ++a)
      fields.velocity[a][at] = u[a];
  });
  sum_over_ranks(fields.pressure);
  for (auto& component : fields.velocity)
    sum_over_ranks(component);
  return fields;
}

} // namespace reference::lattice_boltzmann
