#include "reference/memory_meter.hpp"

#include <algorithm>
#include <fstream>
#include <malloc.h>
#include <string>
#include <string_view>
#include <sys/resource.h>

namespace reference {

namespace {

// A line "VmHWM:   1234 kB" of what the kernel says about this process.
std::size_t status_bytes(std::string_view key) {
  std::ifstream in("/proc/self/status");
  for (std::string line; std::getline(in, line);)
    if (line.starts_with(key))
      return 1024 * std::stoul(line.substr(key.size()));
  return 0;
}

} // namespace

MemoryMeter::MemoryMeter() {
  // What was freed goes back to the system, and the high-water mark starts again from here.
  ::malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << 5;
  before_ = status_bytes("VmRSS:");
}

std::size_t MemoryMeter::bytes() const {
  const std::size_t peak = status_bytes("VmHWM:");
  rusage children{};
  ::getrusage(RUSAGE_CHILDREN, &children);
  return std::max(peak - std::min(peak, before_), static_cast<std::size_t>(children.ru_maxrss) * 1024);
}

} // namespace reference
