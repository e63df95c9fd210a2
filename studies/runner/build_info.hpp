#pragma once

#include <string>

namespace studies {

/// Where the answers of this executable come from.
struct BuildInfo {
  std::string answer_sources; // digest of all sources that can change an answer, compiler and flags included
  std::string commit;         // with "-dirty" when the sources were changed since; "unknown" outside of git
  std::string compiler;
  std::string flags;
};

const BuildInfo& build_info();

/// Processor and number of cores of this machine.
std::string machine();

} // namespace studies
