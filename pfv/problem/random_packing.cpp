#include "pfv/problem/error.hpp"
#include "pfv/problem/generate.hpp"

namespace pfv {

Packing random_packing(const RandomPacking&) {
  throw SolveError("random packings are not made yet");
}

} // namespace pfv
