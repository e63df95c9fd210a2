#include "studies/motion/stability/original_motion.hpp"

#include "pfv/problem/error.hpp"
#include "pfv/problem/text.hpp"
#include "reference/temporary_folder.hpp"
#include "reference/yade/program.hpp"
#include "studies/motion/stability/original.hpp"
#include "studies/motion/yade_oedometer.hpp"
#include "studies/runner/files.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace studies {

extern const char* const original_resistance_py;

namespace {

using namespace pfv;
using nlohmann::json;

json question_about(const Packing& packing) {
  json spheres = json::array();
  for (const auto& [centre, radius] : packing.spheres)
    spheres.push_back({centre.x(), centre.y(), centre.z(), radius});
  const Vec3 &lower = packing.box.lower, &upper = packing.box.upper;
  return {{"box", {lower.x(), lower.y(), lower.z(), upper.x(), upper.y(), upper.z()}}, {"spheres", spheres}};
}

/// Rows and columns of the spheres that count.
Eigen::MatrixXd matrix_from(const json& columns, const std::vector<bool>& counts) {
  std::vector<std::size_t> kept;
  for (std::size_t m = 0; m < columns.size(); ++m)
    if (counts[m / 3])
      kept.push_back(m);
  const auto size = static_cast<Eigen::Index>(kept.size());
  Eigen::MatrixXd matrix(size, size);
  for (Eigen::Index column = 0; column < size; ++column)
    for (Eigen::Index row = 0; row < size; ++row)
      matrix(row, column) = columns[kept[static_cast<std::size_t>(column)]][kept[static_cast<std::size_t>(row)]];
  return matrix;
}

} // namespace

OriginalResistance original_resistance(const Packing& packing) {
  if (reference::yade::missing_program())
    return {{}, not_installed};
  const reference::TemporaryFolder folder("yade");
  write_file(folder.path() / "question.json", question_about(packing).dump());
  write_file(folder.path() / "resistance.py", original_resistance_py);
  try {
    reference::yade::run_script(folder.path(), "resistance.py", original_wall_limit);
    const json reply = json::parse(read_text(folder.path() / "reply.json"));
    return {matrix_from(reply.at("columns"), away_from_corners(packing)), {}};
  } catch (const SolveError& error) {
    return {{}, in_words(error.what())};
  } catch (const InputError&) {
    return {{}, "no answer, exit code 0"};
  } catch (const json::exception&) { // Python writes NaN, which JSON has not
    return {{}, "nan, exit code 0"};
  }
}

namespace {

std::string outcome_of_steps(const Scene& scene, double step) {
  const auto& law = std::get<LinearSprings>(scene.grains.law);
  const double stress = std::get<LoadedWall>(scene.grains.walls.motion[index(Face::z_max)]).stress;
  try {
    const YadeOedometerReply reply = run_yade_oedometer(scene.packing,
                                                        {.young = law.young,
                                                         .tangential_ratio = law.tangential_ratio,
                                                         .friction = law.friction.coefficient,
                                                         .density = scene.grains.density,
                                                         .stress = stress,
                                                         .load = stress,
                                                         .viscosity = scene.fluid->fluid.viscosity,
                                                         .step = step,
                                                         .steps = 3000},
                                                        original_wall_limit);
    const double smallest = std::ranges::min(scene.packing.spheres, {}, &Sphere::radius).radius;
    const double moved = reply.fastest * step / smallest;
    if (!std::isfinite(moved) || !std::isfinite(reply.settlement))
      return "nan, exit code 0";
    if (moved > 0.5)
      return fmt::format("blown up in silence: a grain moves by {:.2g} radii in a step, exit code 0", moved);
    return fmt::format("settles by {:.3g} m", reply.settlement);
  } catch (const SolveError& error) {
    return in_words(error.what());
  }
}

} // namespace

Theirs original_steps(const Scene& scene, const std::vector<double>& shares) {
  if (reference::yade::missing_program())
    return {not_installed};
  const double limit = *Simulation(scene).limits().viscous;
  std::string words;
  for (const double share : shares)
    words += fmt::format("{}at {:g}: {}", words.empty() ? "" : "; ", share, outcome_of_steps(scene, share * limit));
  return {words};
}

} // namespace studies
