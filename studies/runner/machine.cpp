#include "studies/runner/build_info.hpp"

#include <fmt/format.h>

#include <fstream>
#include <thread>

namespace studies {

std::string machine() {
  std::string processor = "unknown processor";
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);)
    if (const auto colon = line.find(": "); line.starts_with("model name") && colon != std::string::npos) {
      processor = line.substr(colon + 2);
      break;
    }
  return fmt::format("{}, {} cores", processor, std::thread::hardware_concurrency());
}

} // namespace studies
