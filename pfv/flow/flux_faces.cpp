#include "pfv/flow/flux_faces.hpp"

#include "pfv/flow/fluxes.hpp"
#include "pfv/problem/error.hpp"

#include <Eigen/LU>
#include <fmt/format.h>

namespace pfv {
namespace {

constexpr double no_way = 1e-12; // of what the pores on a face would conduct

std::vector<Face> flux_faces(const FaceConditions& faces) {
  std::vector<Face> found;
  for (const Face face : all_faces)
    if (std::holds_alternative<Flux>(faces[index(face)]))
      found.push_back(face);
  return found;
}

/// The flow with the pores of one face at a pressure of one and all other known pressures zero.
struct Response {
  Eigen::VectorXd right_side;
  std::vector<double> known;
  double conductance = 0; // m^3/(Pa s), of all throats that leave the face
};

Response response_to(Face face, const PoreNetwork& network, const FlowSystem& system) {
  Response response{Eigen::VectorXd::Zero(system.right_side.size()),
                    std::vector<double>(system.unknown_of_pore.size(), 0.0)};
  for (std::size_t i = 0; i < response.known.size(); ++i)
    if (const auto* known = system.known(i); known && known->source == index(face))
      response.known[i] = 1;
  for (std::size_t t = 0; t < network.throats.size(); ++t) {
    const auto [i, j] = network.throats.pores[t];
    const int a = system.unknown_of_pore[i], b = system.unknown_of_pore[j];
    const double k = system.conductance[t];
    if (a >= 0)
      response.right_side[a] += k * response.known[j];
    if (b >= 0)
      response.right_side[b] += k * response.known[i];
    response.conductance += k * std::abs(response.known[i] - response.known[j]);
  }
  return response;
}

std::vector<double> with_unknowns(std::vector<double> pressure, const FlowSystem& system,
                                  const Eigen::VectorXd& solution) {
  for (std::size_t i = 0; i < pressure.size(); ++i)
    if (system.unknown_of_pore[i] >= 0)
      pressure[i] = solution[system.unknown_of_pore[i]];
  return pressure;
}

} // namespace

void solve_with_flux_faces(const PoreNetwork& network, FlowSystem& system, FlowSolver& solver,
                           Eigen::VectorXd& solution) {
  solver.solve(system.right_side, solution);
  const std::vector<Face> faces = flux_faces(system.faces);
  if (faces.empty())
    return;
  for (const Face face : faces)
    impose(system, face, 0);
  const auto count = static_cast<Eigen::Index>(faces.size());
  const auto fluxes = [&](const std::vector<double>& pressure) {
    const auto out = outflow(network, system, pressure);
    Eigen::VectorXd through(count);
    for (Eigen::Index f = 0; f < count; ++f)
      through[f] = out.face[index(faces[f])];
    return through;
  };
  Eigen::VectorXd missing = -fluxes(pore_pressures(system, solution));
  Eigen::MatrixXd conductance(count, count), responses(solution.size(), count);
  for (Eigen::Index f = 0; f < count; ++f) {
    const double value = std::get<Flux>(system.faces[index(faces[f])]).value;
    missing[f] -= value;
    const Response response = response_to(faces[f], network, system);
    Eigen::VectorXd unknown;
    solver.solve(response.right_side, unknown);
    responses.col(f) = unknown;
    conductance.col(f) = fluxes(with_unknowns(response.known, system, unknown));
    if (!(std::abs(conductance(f, f)) > no_way * response.conductance))
      throw SolveError(fmt::format("flux {} m^3/s of {} has no way to a face or point with a pressure", value,
                                   face_names[index(faces[f])]));
  }
  const Eigen::VectorXd pressure = conductance.partialPivLu().solve(missing);
  solution += responses * pressure;
  for (Eigen::Index f = 0; f < count; ++f)
    impose(system, faces[f], pressure[f]);
}

} // namespace pfv
