#include "studies/runner/run_key.hpp"

#include "studies/runner/files.hpp"

#include <fmt/format.h>

namespace studies {

std::string digest(const RunKey& key) {
  return text_digest(fmt::format("{}\n{}\n{}\n{}\n{}\n{}\n{}\n{}", key.case_id, key.case_digest, key.method,
                                 key.mesh_size, key.ranks, key.samples, key.method_version, key.answer_sources));
}

} // namespace studies
