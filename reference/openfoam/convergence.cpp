#include "reference/openfoam/convergence.hpp"

#include "meshing/child_process.hpp"
#include "pfv/problem/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <sstream>

namespace reference::openfoam {

namespace {

int converged_in(const std::filesystem::path& log) {
  const std::string sentence = "SIMPLE solution converged in ";
  std::ifstream in(log);
  for (std::string line; std::getline(in, line);)
    if (line.starts_with(sentence))
      return std::stoi(line.substr(sentence.size()));
  throw pfv::SolveError("simpleFoam did not converge; its last words: " + meshing::last_lines(log, 8));
}

std::vector<double> flux_history(const std::filesystem::path& file) {
  std::vector<double> history;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    std::istringstream columns(line);
    double iteration = 0, flux = 0;
    if (columns >> iteration >> flux)
      history.push_back(flux);
  }
  if (history.empty())
    throw pfv::SolveError("simpleFoam recorded no flux of " + file.parent_path().parent_path().filename().string());
  return history;
}

} // namespace

Convergence read_convergence(const std::filesystem::path& folder, const std::vector<std::string>& open_faces) {
  Convergence found;
  found.iterations = converged_in(folder / "log.simpleFoam");
  double change = 0, largest = 0;
  for (const std::string& face : open_faces) {
    const auto history = flux_history(folder / "postProcessing" / face / "0" / "surfaceFieldValue.dat");
    const std::size_t before = history.size() - 1 - std::min(history.size() - 1, history.size() / 10 + 1);
    change = std::max(change, std::abs(history.back() - history[before]));
    largest = std::max(largest, std::abs(history.back()));
  }
  found.flux_drift = change / largest;
  return found;
}

} // namespace reference::openfoam
