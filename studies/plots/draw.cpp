#include "studies/plots/draw.hpp"

#include "meshing/child_process.hpp"
#include "reference/on_path.hpp"
#include "reference/temporary_folder.hpp"
#include "studies/plots/plot_script.hpp"
#include "studies/plots/svg_for_pages.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

namespace studies {

Drawing draw(const Plot& plot, const std::string& id_prefix) {
  if (!reference::on_path("gnuplot"))
    return {"", "there is no gnuplot here to draw it"};
  const reference::TemporaryFolder folder("plot");
  std::ofstream(folder.path() / "plot.gp") << plot_script(plot);
  const auto log = folder.path() / "log";
  const auto ended =
      meshing::run_child({"gnuplot", "plot.gp"}, {.working_folder = folder.path(), .log = log, .wall_limit = 60});
  if (!ended.succeeded())
    return {"", fmt::format("gnuplot could not draw it, {}: {}", ended.how_it_ended(), meshing::last_lines(log))};
  std::ifstream in(folder.path() / "plot.svg");
  return {svg_for_pages(std::string(std::istreambuf_iterator<char>(in), {}), id_prefix), ""};
}

} // namespace studies
