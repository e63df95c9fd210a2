#include "reference/stokes_fem/ranks_reply.hpp"

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace reference::stokes_fem {

namespace {

using nlohmann::json;

std::streamsize bytes(const Eigen::VectorXd& values) {
  return static_cast<std::streamsize>(values.size()) * static_cast<std::streamsize>(sizeof(double));
}

} // namespace

std::string to_json(const RanksReply& reply) {
  return json{{"face_flux", reply.face_flux},
              {"dissipation", reply.dissipation},
              {"residual", reply.residual},
              {"imbalance", reply.imbalance},
              {"iterations", reply.iterations},
              {"velocity_nodes", reply.velocity_nodes},
              {"pressure_nodes", reply.pressure_nodes},
              {"free_velocities", reply.free_velocities},
              {"assemble_seconds", reply.assemble_seconds},
              {"factor_seconds", reply.factor_seconds},
              {"solve_seconds", reply.solve_seconds},
              {"peak_memory", reply.peak_memory}}
      .dump();
}

RanksReply ranks_reply_from_json(const std::string& text) {
  const json from = json::parse(text);
  RanksReply reply;
  from.at("face_flux").get_to(reply.face_flux);
  from.at("dissipation").get_to(reply.dissipation);
  from.at("residual").get_to(reply.residual);
  from.at("imbalance").get_to(reply.imbalance);
  from.at("iterations").get_to(reply.iterations);
  from.at("velocity_nodes").get_to(reply.velocity_nodes);
  from.at("pressure_nodes").get_to(reply.pressure_nodes);
  from.at("free_velocities").get_to(reply.free_velocities);
  from.at("assemble_seconds").get_to(reply.assemble_seconds);
  from.at("factor_seconds").get_to(reply.factor_seconds);
  from.at("solve_seconds").get_to(reply.solve_seconds);
  from.at("peak_memory").get_to(reply.peak_memory);
  return reply;
}

void write_flow(const FlowField& flow, const std::filesystem::path& file) {
  std::ofstream out(file, std::ios::binary);
  for (const Eigen::VectorXd* values : {&flow.velocity[0], &flow.velocity[1], &flow.velocity[2], &flow.pressure})
    out.write(reinterpret_cast<const char*>(values->data()), bytes(*values));
  if (!out.flush())
    throw std::runtime_error("cannot write '" + file.string() + "'");
}

FlowField read_flow(const std::filesystem::path& file, std::size_t velocity_nodes, std::size_t pressure_nodes) {
  FlowField flow;
  for (Eigen::VectorXd& velocity : flow.velocity)
    velocity.resize(static_cast<Eigen::Index>(velocity_nodes));
  flow.pressure.resize(static_cast<Eigen::Index>(pressure_nodes));
  std::ifstream in(file, std::ios::binary);
  for (Eigen::VectorXd* values : {&flow.velocity[0], &flow.velocity[1], &flow.velocity[2], &flow.pressure})
    if (!in.read(reinterpret_cast<char*>(values->data()), bytes(*values)))
      throw std::runtime_error("'" + file.string() + "' ends early");
  if (in.peek() != std::ifstream::traits_type::eof())
    throw std::runtime_error("'" + file.string() + "' holds another flow");
  return flow;
}

} // namespace reference::stokes_fem
