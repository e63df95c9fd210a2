#pragma once

#include "pfv/problem/case.hpp"

#include <string>
#include <vector>

namespace pfv {

/// Where the parts of a packing were written, for messages; empty for a packing that was not read.
struct PackingOrigin {
  std::string file;
  int box_line = 0;
  std::vector<int> sphere_lines;
};

/// The parts of validate(case); each throws InputError on the first thing no method can work with.
void validate(const Packing& packing, const PackingOrigin& origin);
void validate(const Fluid& fluid);
void validate(const FaceConditions& faces);
void validate(const Buoyancy& buoyancy);

} // namespace pfv
