#pragma once

#include <string>

namespace studies {

/// All that a stored answer depends on.
struct RunKey {
  std::string case_id; // two cases of a study with the same question keep a row each
  std::string case_digest;
  std::string method;
  double mesh_size;
  int ranks;
  bool samples;
  std::string method_version;
  std::string answer_sources;
};

/// 32 hexadecimal digits: two runs with one key have the same answer, so the second is not run.
std::string digest(const RunKey& key);

} // namespace studies
