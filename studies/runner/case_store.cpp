#include "studies/runner/case_store.hpp"

#include "pfv/problem/error.hpp"
#include "pfv/problem/toml_input.hpp"
#include "reference/temporary_folder.hpp"
#include "studies/runner/files.hpp"

#include <fmt/format.h>

#include <functional>
#include <sstream>

namespace studies {

namespace {

// The question with its packing in a file of numbers beside it: a million spheres in TOML take a gigabyte to read.
void write_out(const pfv::Packing& packing, const std::filesystem::path& asked, const std::filesystem::path& full,
               const std::string& name) {
  auto spheres = full;
  spheres.replace_extension(".txt");
  std::ostringstream numbers;
  pfv::write_packing(packing, numbers);
  write_file(spheres, numbers.str());
  toml::table question = pfv::read_toml(asked);
  question.insert_or_assign("name", name);
  question.insert_or_assign("packing", toml::table{{"file", spheres.filename().string()}});
  std::ostringstream text;
  text << question << '\n';
  write_file(full, text.str());
}

// The case of a file, or what `otherwise` gives when it is not there or damaged.
pfv::Case read_or(const std::filesystem::path& file, const std::function<pfv::Case()>& otherwise) {
  if (std::filesystem::exists(file))
    try {
      return pfv::read_case(file);
    } catch (const pfv::InputError&) {
    }
  return otherwise();
}

} // namespace

pfv::Case problem_of(const StudyCase& one) {
  const reference::TemporaryFolder folder("case");
  const auto file = folder.path() / "case.toml";
  write_file(file, one.toml);
  return pfv::read_case(file);
}

StoredCase store_case(const StudyCase& one, const std::filesystem::path& folder, const std::string& generation) {
  const std::string question = text_digest(one.toml + generation).substr(0, 12);
  const auto full = folder / fmt::format("{}-{}.toml", one.id, question);
  // What a packing file holds may have changed since; what a generator makes cannot have.
  const bool generated = one.toml.find("generator") != std::string::npos;
  const auto write_anew = [&] {
    const auto asked = folder / fmt::format("{}-{}.question.toml", one.id, question);
    write_file(asked, one.toml);
    pfv::Case read = pfv::read_case(asked);
    write_out(read.packing, asked, full, one.id);
    pfv::Case written = pfv::read_case(full);
    written.notes = std::move(read.notes); // of the reader, which saw the packing as it came
    return written;
  };
  try {
    StoredCase stored{generated ? read_or(full, write_anew) : write_anew(), {}, full};
    stored.digest = pfv::digest(stored.problem);
    return stored;
  } catch (const std::runtime_error& error) {
    throw pfv::InputError(fmt::format("{}: case \"{}\": {}", one.place, one.id, error.what()));
  }
}

} // namespace studies
