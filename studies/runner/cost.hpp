#pragma once

#include "pfv/clock.hpp"

#include <vector>

namespace studies {

/// The CPU seconds of one answer, split by how often a user of the method pays them.
struct Cost {
  double mesh = 0;   // making the mesh: once per packing, and counted in full even when it came from a cache
  double once = 0;   // all other preparation: geometry, assembly, factorisation; once per packing, kept while it stands
  double solve = 0;  // one more question to the same packing: stages "solve" and "forces"
  double repeat = 0; // one more step of a moving packing, when it was measured; beside the answer, so not in the total

  double total() const { return mesh + once + solve; }
  bool operator==(const Cost&) const = default;
};

/// By stage name: "mesh" and what begins with "mesh "; "solve" and "forces"; what begins with
/// reference::repeat_prefix is repeat; everything else is once.
Cost cost(const std::vector<pfv::Stage>& stages);

} // namespace studies
