#include "studies/runner/cost.hpp"

#include "reference/answer.hpp"

namespace studies {

Cost cost(const std::vector<pfv::Stage>& stages) {
  Cost split;
  for (const pfv::Stage& stage : stages) {
    if (stage.name.starts_with(reference::repeat_prefix))
      split.repeat += stage.cpu_seconds;
    else if (stage.name == "mesh" || stage.name.starts_with("mesh "))
      split.mesh += stage.cpu_seconds;
    else if (stage.name == "solve" || stage.name == "forces")
      split.solve += stage.cpu_seconds;
    else
      split.once += stage.cpu_seconds;
  }
  return split;
}

} // namespace studies
