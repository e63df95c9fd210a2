#include "pfv/solvers/flow_solver.hpp"

#include "pfv/problem/error.hpp"
#include "pfv/solvers/amg_solver.hpp"
#include "pfv/solvers/auto_solver.hpp"
#include "pfv/solvers/cholmod_solver.hpp"
#include "pfv/solvers/gauss_seidel.hpp"
#include "pfv/solvers/multigrid_solver.hpp"

#include <fmt/format.h>

namespace pfv {
namespace {

std::unique_ptr<FlowSolver> make(const AutoSolver& parameters) {
  return make_auto_solver(parameters);
}

std::unique_ptr<FlowSolver> make(const Cholmod&) {
  return make_cholmod();
}

std::unique_ptr<FlowSolver> make(const GaussSeidel& parameters) {
  return make_gauss_seidel(parameters);
}

std::unique_ptr<FlowSolver> make(const Amg& parameters) {
  return make_amg(parameters);
}

std::unique_ptr<FlowSolver> make(const Multigrid& parameters) {
  return make_multigrid(parameters);
}

} // namespace

SolverChoice solver_named(std::string_view name) {
  if (name == "auto")
    return AutoSolver{};
  if (name == "cholmod")
    return Cholmod{};
  if (name == "gauss-seidel")
    return GaussSeidel{};
  if (name == "amg")
    return Amg{};
  if (name == "multigrid")
    return Multigrid{};
  throw InputError(fmt::format("solver \"{}\" is not one of auto, cholmod, gauss-seidel, amg, multigrid", name));
}

std::unique_ptr<FlowSolver> make_solver(const SolverChoice& choice) {
  return std::visit([](const auto& parameters) { return make(parameters); }, choice);
}

} // namespace pfv
