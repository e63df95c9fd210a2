#pragma once

#include "studies/runner/study_file.hpp"

#include <string>
#include <vector>

namespace studies {

/// Which part of a study to do.
struct Scope {
  bool quick = false;               // quick cases, methods and mesh sizes only
  std::vector<std::string> methods; // only these; all when empty
};

struct PlannedRun {
  std::string case_id;
  std::string method;
  double mesh_size;
  int ranks = 1;

  bool operator==(const PlannedRun&) const = default;
};

/// The runs of a study in the order of its tables: by case, by method, coarse to fine. A method without a mesh (no
/// convergence order) runs once, at mesh size 1. Throws pfv::InputError when `scope` names a method the study has not.
std::vector<PlannedRun> plan(const Study& study, const Scope& scope);

} // namespace studies
