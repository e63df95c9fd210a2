#include "studies/motion/yade_oedometer.hpp"

#include "pfv/problem/error.hpp"
#include "pfv/problem/text.hpp"
#include "reference/temporary_folder.hpp"
#include "reference/yade/program.hpp"
#include "studies/runner/files.hpp"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace studies {

extern const char* const yade_oedometer_py;

namespace {

using namespace pfv;

/// What is along z here is along y there.
std::array<double, 3> turned(const Vec3& point) {
  return {point.x(), point.z(), point.y()};
}

double number_or_nan(const nlohmann::json& value) {
  return value.is_number() ? value.get<double>() : std::nan("");
}

} // namespace

YadeOedometerReply run_yade_oedometer(const Packing& packing, const YadeOedometer& question, double wall_limit) {
  const reference::TemporaryFolder folder("yade");
  nlohmann::json spheres = nlohmann::json::array();
  for (const Sphere& sphere : packing.spheres) {
    const auto [x, y, z] = turned(sphere.centre);
    spheres.push_back({x, y, z, sphere.radius});
  }
  const auto lower = turned(packing.box.lower), upper = turned(packing.box.upper);
  write_file(folder.path() / "question.json",
             nlohmann::json{{"box", {lower[0], lower[1], lower[2], upper[0], upper[1], upper[2]}},
                            {"spheres", spheres},
                            {"young", question.young},
                            {"tangential_ratio", question.tangential_ratio},
                            {"friction", question.friction},
                            {"density", question.density},
                            {"stress", question.stress},
                            {"load", question.load},
                            {"viscosity", question.viscosity},
                            {"step", question.step},
                            {"steps", question.steps},
                            {"steps_at_rest", question.steps_at_rest}}
                 .dump());
  write_file(folder.path() / "oedometer.py", yade_oedometer_py);
  reference::yade::run_script(folder.path(), "oedometer.py", wall_limit);
  try {
    const auto reply = nlohmann::json::parse(read_text(folder.path() / "reply.json"));
    return {reply.at("version"), reply.at("cpu_seconds"), number_or_nan(reply.at("settlement")),
            number_or_nan(reply.at("fastest"))};
  } catch (const InputError& error) {
    throw SolveError(fmt::format("yade left no reply: {}", error.what()));
  }
}

} // namespace studies
