#pragma once

#include <map>
#include <string>
#include <vector>

namespace studies {

/// Where the answers of this executable come from.
struct BuildInfo {
  /// Digests of the sources of pfv/, meshing/ and reference/ by folder ("reference/openfoam"), with all below it; of
  /// what lies directly in it by its name and "/*".
  std::map<std::string, std::string> sources;
  std::string commit; // with "-dirty" when the sources were changed since; "unknown" outside of git
  std::string compiler;
  std::string flags;
};

const BuildInfo& build_info();

/// Digest of the compiler, its flags, the sources of these folders and those directly in pfv/ and reference/. Throws
/// pfv::InputError for a folder that has no sources.
std::string digest_of_sources(const std::vector<std::string>& folders);

/// Processor and number of cores of this machine.
std::string machine();

} // namespace studies
