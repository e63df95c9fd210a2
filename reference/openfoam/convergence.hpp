#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace reference::openfoam {

struct Convergence {
  int iterations = 0;
  double flux_drift = 0; // largest change of a face's flux over the last tenth of the iterations, over the largest flux
};

/// How simpleFoam's iteration ended: from its log, which says "converged" only when the residuals are small (a run that
/// diverged or ran out of iterations exits with 0 and "End" all the same), and from the recorded fluxes of
/// `open_faces`. Throws pfv::SolveError with the end of the log when it did not converge.
Convergence read_convergence(const std::filesystem::path& folder, const std::vector<std::string>& open_faces);

} // namespace reference::openfoam
