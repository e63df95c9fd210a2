#pragma once

#include "studies/runner/study_run.hpp"
#include "studies/runner/terminal.hpp"

#include <memory>
#include <ostream>

namespace studies {

/// Tells of runs as they go: on a terminal one line that is rewritten, with a bar of elapsed over expected seconds;
/// else a line when a run starts and one when it ends, without any escape code.
class Progress {
public:
  Progress(std::ostream& out, const Terminal& terminal);
  ~Progress(); // clears the live line
  Onlooker onlooker();

private:
  class State;
  std::shared_ptr<State> state_;
};

/// "[#####.....] 12 s of about 25 s" in `width` characters or fewer; past the expected time the bar stays full.
std::string progress_bar(double elapsed_seconds, double expected_seconds, int width);

} // namespace studies
