#include "pfv/flow/flow_solver.hpp"

#include "pfv/flow/cholmod_solver.hpp"
#include "pfv/flow/gauss_seidel.hpp"
#include "pfv/problem/error.hpp"

#include <fmt/format.h>

namespace pfv {

SolverChoice solver_named(std::string_view name) {
  if (name == "auto")
    return AutoSolver{};
  if (name == "cholmod")
    return Cholmod{};
  if (name == "gauss-seidel")
    return GaussSeidel{};
  throw InputError(fmt::format("solver \"{}\" is not one of auto, cholmod, gauss-seidel", name));
}

std::unique_ptr<FlowSolver> make_solver(const SolverChoice& choice) {
  if (const auto* parameters = std::get_if<GaussSeidel>(&choice))
    return make_gauss_seidel(*parameters);
  return make_cholmod();
}

} // namespace pfv
