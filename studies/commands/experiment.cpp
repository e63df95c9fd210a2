#include "studies/commands/experiment.hpp"

#include "pfv/problem/error.hpp"
#include "pfv/problem/text.hpp"
#include "studies/commands/publish.hpp"
#include "studies/commands/study_place.hpp"
#include "studies/document/markdown.hpp"
#include "studies/runner/progress.hpp"
#include "studies/runner/terminal.hpp"
#include "studies/runner/write_pages.hpp"

#include <chrono>
#include <fmt/format.h>

namespace studies {
namespace {

std::filesystem::path work_folder(const Experiment& experiment, const std::filesystem::path& work) {
  return work.empty() ? studies_folder() / experiment.name / "work" : work;
}

/// One line, rewritten a few times a second on a terminal; elsewhere one when something else is being done.
class Line {
public:
  void operator()(const std::string& what, double done) {
    const auto now = Time::now();
    if (what != what_) {
      what_ = what;
      start_ = now;
      if (!live_)
        fmt::print(stderr, "{} ...\n", what);
    }
    if (!live_ || (done > 0 && now - shown_ < std::chrono::milliseconds(200)))
      return;
    shown_ = now;
    const double past = std::chrono::duration<double>(now - start_).count();
    fmt::print(stderr, "\r\033[K{} {}", what, done > 0 ? progress_bar(past, past / done, 50) : "...");
  }
  void clear() const {
    if (live_)
      fmt::print(stderr, "\r\033[K");
  }

private:
  using Time = std::chrono::steady_clock;
  bool live_ = terminal().live_progress;
  std::string what_;
  Time::time_point start_, shown_;
};

} // namespace

int run_experiment(const Experiment& experiment, bool quick, const std::filesystem::path& work) {
  fmt::print(stderr, "{}: {}\n", experiment.name, experiment.title);
  Line line;
  const ExperimentReport report =
      experiment.run(quick, [&](const std::string& what, double done) { line(what, done); });
  line.clear();
  const auto folder = work_folder(experiment, work);
  const auto page = write_report(report, folder, readme_of(studies_folder() / experiment.name));
  fmt::print("\n{}\n{}\nReport: {}\n", report.summary,
             report.holds ? "Holds." : "DOES NOT HOLD: something is outside of its bound.", page.string());
  return report.holds ? 0 : 1;
}

void report_experiment(const Experiment& experiment, bool publish, const std::filesystem::path& work) {
  const auto folder = work_folder(experiment, work);
  if (!std::filesystem::exists(folder / "report.md"))
    throw pfv::InputError(fmt::format("{} has no report; `study run {}` makes it", folder.string(), experiment.name));
  const std::string text = pfv::read_text(folder / "report.md");
  const auto readme = readme_of(studies_folder() / experiment.name);
  const auto page = write_pages(from_markdown(text), folder, readme);
  fmt::print("{}\nReport: {}\n", text, page.string());
  if (!publish)
    return;
  const auto published = studies_folder() / experiment.name / "results";
  std::filesystem::create_directories(published);
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.is_regular_file())
      std::filesystem::copy_file(entry.path(), published / entry.path().filename(),
                                 std::filesystem::copy_options::overwrite_existing);
  write_pages(from_markdown(text), published, readme); // its links are other ones from there
  fmt::print(stderr, "Published: {}\n", published.string());
}

} // namespace studies
