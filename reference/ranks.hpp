#pragma once

#include "meshing/child_process.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace reference {

/// The command that has mpirun start a program on several ranks of this machine, on however many cores.
/// Throws pfv::SolveError when there is no mpirun on PATH.
std::vector<std::string> on_ranks(int ranks, std::vector<std::string> command);

/// Adds what programs that speak MPI want in their environment: started by root too, one thread a rank, and ranks that
/// wait leave their core to others.
void prepare_for_ranks(meshing::ChildOptions& options);

/// A solver that is a program of this project, for what may take its whole process down or needs one for each rank.
class SolverProgram {
public:
  /// `built` is where this build puts it, empty when it has none.
  SolverProgram(std::string name, std::string variable, std::filesystem::path built);

  /// `$variable`, else libexec beside the folder of the running program, else where it was built.
  std::filesystem::path path() const;
  /// Runs it in a folder, by mpirun if on more than one rank, and stops it after `wall_limit` (s). It may leave the
  /// cause of a failure in `failure.txt` there. Throws pfv::SolveError with that, or the end of its output.
  meshing::ChildResult run(std::vector<std::string> arguments, const std::filesystem::path& folder, int ranks,
                           double wall_limit) const;

private:
  std::string name_;
  std::string variable_;
  std::filesystem::path built_;
};

} // namespace reference
