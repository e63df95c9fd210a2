#include "studies/runner/case_store.hpp"

#include "pfv/problem/error.hpp"
#include "studies/runner/files.hpp"

#include <fmt/format.h>

namespace studies {

StoredCase store_case(const StudyCase& one, const std::filesystem::path& folder, const std::string& generation) {
  const std::string question = text_digest(one.toml + generation).substr(0, 12);
  const auto full = folder / fmt::format("{}-{}.toml", one.id, question);
  // What a packing file holds may have changed since; what a generator makes cannot have.
  const bool generated = one.toml.find("generator") != std::string::npos;
  try {
    if (!generated || !std::filesystem::exists(full)) {
      const auto asked = folder / fmt::format("{}-{}.question.toml", one.id, question);
      write_file(asked, one.toml);
      pfv::Case problem = pfv::read_case(asked);
      problem.name = one.id;
      write_file(full, pfv::to_toml(problem));
    }
    StoredCase stored{pfv::read_case(full), {}, full};
    stored.digest = pfv::digest(stored.problem);
    return stored;
  } catch (const std::runtime_error& error) {
    throw pfv::InputError(fmt::format("{}: case \"{}\": {}", one.place, one.id, error.what()));
  }
}

} // namespace studies
