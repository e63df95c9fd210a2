#include "pfv/clock.hpp"
#include "pfv/problem/text.hpp"
#include "reference/lattice_boltzmann/lattice_flow/all_ranks.hpp"
#include "reference/lattice_boltzmann/lattice_flow/flow_lattice.hpp"
#include "reference/lattice_boltzmann/lattice_flow/palabos.hpp"
#include "reference/lattice_boltzmann/lattice_flow/samples.hpp"
#include "reference/lattice_boltzmann/lattice_flow/settling.hpp"
#include "reference/lattice_boltzmann/pockets.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <stdexcept>

namespace reference::lattice_boltzmann {

namespace {

constexpr int steps_between_looks = 50;

void run_to_rest(const FlowQuestion& question, FlowLattice& flow, FlowReply& reply) {
  Settling settling;
  FlowState state;
  while (reply.steps < question.most_steps && !reply.settled) {
    for (int i = 0; i < steps_between_looks; ++i)
      flow.step();
    reply.steps += steps_between_looks;
    state = flow.state();
    settling.add(state.velocity);
    reply.balance = 1 - state.taken_up;
    reply.drift = settling.drift();
    if (!std::isfinite(state.velocity))
      throw std::runtime_error("the flow blew up after " + std::to_string(reply.steps) + " steps");
    reply.settled = reply.drift < question.tolerance && std::abs(reply.balance) < question.tolerance;
  }
  reply.velocity = state.velocity;
  const auto [least, most] = std::ranges::minmax(state.section_velocity);
  reply.section_velocity = {least, most};
}

double over_ranks(double value) {
  std::array sum{value};
  sum_over_ranks(sum);
  return sum[0];
}

FlowReply answer(const FlowQuestion& question) {
  FlowReply reply;
  Voxels voxels(question);
  reply.pocket_voxels = fill_pockets(question, voxels);
  const auto links = wall_links(question, voxels);
  reply.fluid_voxels = voxels.fluid_count();
  reply.links = links.size();
  reply.narrow_links = static_cast<std::size_t>(std::ranges::count_if(links, &WallLink::narrow));
  reply.solid_voxels = voxels.solid_counts(question.spheres.size());
  FlowLattice flow(question, voxels, links);
  reply.voxel_seconds = over_ranks(pfv::process_cpu_seconds());
  run_to_rest(question, flow, reply);
  if (std::ranges::find(question.beyond, Beyond::is_opposed) == question.beyond.end())
    flow.centre_pressure();
  reply.forces = flow.forces();
  if (!question.points.empty() || !question.facets.empty()) {
    const Fields fields = flow.fields();
    reply.pressures = pressures_at_points(question, voxels, fields);
    reply.fluxes = fluxes_through_facets(question, voxels, fields);
  }
  reply.solve_seconds = over_ranks(pfv::process_cpu_seconds()) - reply.voxel_seconds;
  reply.peak_memory = over_ranks(static_cast<double>(pfv::peak_memory_bytes()));
  return reply;
}

} // namespace

} // namespace reference::lattice_boltzmann

/// lattice_flow question.json reply.json
/// Exit code 1 with the reason in failure.txt.
int main(int argc, char** argv) {
  using namespace reference::lattice_boltzmann;
  if (argc != 3) {
    std::fprintf(stderr, "usage: lattice_flow question.json reply.json\n");
    return 2;
  }
  const std::string question = argv[1];
  const std::string reply_file = argv[2];
  plb::plbInit(&argc, &argv);
  try {
    const FlowReply reply = answer(flow_question_from_json(pfv::read_text(question)));
    if (plb::global::mpi().isMainProcessor()) {
      std::ofstream out(reply_file);
      out << to_json(reply) << '\n';
      if (!out.flush())
        throw std::runtime_error("cannot write " + reply_file);
    }
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    std::ofstream("failure.txt") << error.what() << '\n';
  }
  MPI_Abort(MPI_COMM_WORLD, 1);
}
