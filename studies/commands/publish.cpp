#include "studies/commands/publish.hpp"

#include "studies/runner/files.hpp"
#include "studies/runner/write_pages.hpp"

#include <fmt/format.h>

namespace studies {

std::filesystem::path readme_of(const std::filesystem::path& study_folder) {
  return study_folder.empty() ? "" : study_folder / "README.md";
}

void publish(const Document& page, const std::vector<Row>& rows, const std::filesystem::path& study_folder,
             const std::map<std::string, std::string>& files) {
  const std::filesystem::path published = study_folder / "results";
  write_pages(page, published, readme_of(study_folder));
  std::string csv = to_csv(row_columns());
  for (const Row& row : rows)
    csv += to_csv(to_record(row));
  write_file(published / "rows.csv", csv);
  for (const auto& [name, text] : files)
    write_file(published / name, text);
  fmt::print(stderr, "Published: {}\n", published.string());
}

} // namespace studies
