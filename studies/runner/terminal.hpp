#pragma once

namespace studies {

/// What the two output streams of this process can show.
struct Terminal {
  bool live_progress = false; // standard error is a terminal that lines can be rewritten on
  bool colours = false;       // standard output is a terminal and NO_COLOR is not set
  int width = 80;             // columns of standard error
};

Terminal terminal();

} // namespace studies
