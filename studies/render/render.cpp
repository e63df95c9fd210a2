#include "studies/render/render.hpp"

#include "meshing/child_process.hpp"
#include "pfv/problem/text.hpp"
#include "reference/on_path.hpp"
#include "reference/temporary_folder.hpp"

#include <fmt/format.h>

#include <fstream>

namespace studies {

Rendering render(const RenderScene& scene) {
  const std::string program = RENDER_SCENE_PATH;
  if (program.empty())
    return {"", "this build has no VTK to draw it (Debian package libvtk9-dev)"};
  if (!reference::on_path("xvfb-run"))
    return {"",
            "VTK needs a screen to draw on, and there is no xvfb-run here to make one (Debian packages xvfb, xauth)"};
  const reference::TemporaryFolder folder("render");
  std::ofstream(folder.path() / "scene.json") << to_json(scene);
  const auto log = folder.path() / "log";
  const auto ended = meshing::run_child(
      {"xvfb-run", "--auto-servernum", "--server-args=-screen 0 1024x1024x24", program, "scene.json", "picture.png"},
      {.working_folder = folder.path(), .log = log, .wall_limit = 120});
  if (!ended.succeeded())
    return {"", fmt::format("VTK could not draw it, {}: {}", ended.how_it_ended(), meshing::last_lines(log))};
  return {pfv::read_text(folder.path() / "picture.png"), ""};
}

} // namespace studies
