#include "studies/motion/stability/refusal_trials.hpp"

#include "meshing/child_process.hpp"
#include "pfv/problem/text.hpp"
#include "reference/temporary_folder.hpp"
#include "studies/motion/stability/original.hpp"
#include "studies/runner/build_paths.hpp"
#include "studies/runner/files.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace studies {
namespace {

using namespace pfv;

struct Question {
  const char* name;
  Packing packing;
};

std::string text_of(const Packing& packing) {
  std::ostringstream text;
  write_packing(packing, text);
  return text.str();
}

/// Exit code, and what stands on standard output and standard error.
struct Words {
  int exit_code;
  std::string out, error;
};

Words pfv_says(const std::string& file_name, const std::string& text) {
  const reference::TemporaryFolder folder("refusal");
  write_file(folder.path() / file_name, text);
  const auto child =
      meshing::run_child({"/bin/sh", "-c", "exec \"$0\" permeability \"$1\" >out 2>error", pfv_program, file_name},
                         {.working_folder = folder.path(), .wall_limit = 60});
  return {child.exit_code, read_text(folder.path() / "out"), read_text(folder.path() / "error")};
}

Measured refused(const std::string& file_name, const std::string& text) {
  Words words = pfv_says(file_name, text);
  const auto lines = static_cast<double>(std::ranges::count(words.error, '\n'));
  if (words.error.ends_with('\n'))
    words.error.pop_back();
  return {{{"exit code", static_cast<double>(words.exit_code), 2, 2},
           {"lines of the message", lines, 1, 1},
           {"bytes on standard output", static_cast<double>(words.out.size()), 0, 0}},
          words.error};
}

Trial refusal(const Question& question) {
  Case problem; // as it is: what our reader would not let pass is to reach the original
  problem.packing = question.packing;
  problem.faces = flow_along(Axis::z);
  return {"To be refused", question.name, true, [=] { return refused("packing.txt", text_of(question.packing)); },
          [=] { return original_flow(problem); }};
}

} // namespace

std::vector<Trial> refusal_trials() {
  const Vec3 middle = Vec3::Constant(0.5);
  const std::vector<Sphere> others{{{.2, .2, .2}, .1}, {{.8, .3, .3}, .1}, {{.3, .8, .6}, .1}, {{.7, .7, .8}, .1}};
  const auto with = [&](const Sphere& sphere) {
    Packing packing{{}, others};
    packing.spheres.push_back(sphere);
    return packing;
  };
  std::vector<Trial> trials;
  for (const Question& question :
       {Question{"an empty box", {}}, Question{"a centre outside of the box", with({{1.5, .5, .5}, .1})},
        Question{"a radius that is no number", with({middle, std::nan("")})},
        Question{"a radius of zero", with({middle, 0})}, Question{"a negative radius", with({middle, -0.1})},
        Question{"two identical spheres", with(others.front())}})
    trials.push_back(refusal(question));
  trials.push_back({"To be refused", "no pressure anywhere", true, [] {
                      return refused("closed.toml", "[packing]\nbox = [[0, 0, 0], [1, 1, 1]]\n"
                                                    "spheres = [[0.5, 0.5, 0.5, 0.3]]\n[faces]\nx_min = \"slip\"\n");
                    }});
  return trials;
}

} // namespace studies
