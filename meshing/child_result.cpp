#include "meshing/child_process.hpp"

#include <cctype>
#include <cmath>
#include <cstring>
#include <deque>
#include <fmt/format.h>
#include <fstream>

namespace meshing {

std::string ChildResult::how_it_ended() const {
  if (timed_out)
    return fmt::format("stopped after {:g} s", std::round(wall_seconds * 10) / 10);
  if (signal != 0)
    return fmt::format("killed by signal {} ({})", signal, sigdescr_np(signal));
  return fmt::format("exit code {}", exit_code);
}

std::string last_lines(const std::filesystem::path& log, std::size_t lines) {
  std::ifstream in(log);
  std::deque<std::string> last;
  for (std::string line; std::getline(in, line);) {
    while (!line.empty() && std::isspace(static_cast<unsigned char>(line.back())))
      line.pop_back();
    if (line.empty())
      continue;
    last.push_back(line);
    if (last.size() > lines)
      last.pop_front();
  }
  std::string joined;
  for (const std::string& line : last)
    joined += (joined.empty() ? "" : " | ") + line;
  return joined;
}

} // namespace meshing
