#include "pfv/problem/error.hpp"
#include "studies/runner/build_info.hpp"
#include "studies/runner/files.hpp"

#include <fmt/format.h>

namespace studies {

std::string digest_of_sources(const std::vector<std::string>& folders) {
  const BuildInfo& build = build_info();
  std::string digests = build.compiler + " " + build.flags;
  const auto add = [&](const std::string& folder) {
    const auto found = build.sources.find(folder);
    if (found == build.sources.end())
      throw pfv::InputError(fmt::format("no sources in the folder \"{}\"", folder));
    digests += "\n" + folder + " " + found->second;
  };
  add("pfv/*");
  add("reference/*");
  for (const std::string& folder : folders)
    add(folder);
  return text_digest(digests).substr(0, 16);
}

} // namespace studies
