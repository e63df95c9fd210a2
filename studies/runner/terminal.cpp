#include "studies/runner/terminal.hpp"

#include <cstdlib>
#include <string_view>
#include <sys/ioctl.h>
#include <unistd.h>

namespace studies {

Terminal terminal() {
  const char* type = std::getenv("TERM");
  const bool dumb = !type || std::string_view(type) == "dumb";
  const char* no_colour = std::getenv("NO_COLOR");
  Terminal result;
  result.live_progress = ::isatty(STDERR_FILENO) && !dumb;
  result.colours = ::isatty(STDOUT_FILENO) && !dumb && (!no_colour || !*no_colour);
  winsize size{};
  if (::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0)
    result.width = size.ws_col;
  return result;
}

} // namespace studies
