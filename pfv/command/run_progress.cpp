#include "pfv/command/run_progress.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fmt/format.h>
#include <string_view>
#include <unistd.h>

namespace pfv {
namespace {

constexpr int bar_width = 20;
constexpr auto between = std::chrono::milliseconds(200);
constexpr std::string_view back_to_an_empty_line = "\r\033[K";

bool is_terminal() {
  const char* type = std::getenv("TERM");
  return isatty(STDERR_FILENO) != 0 && type && std::string_view(type) != "dumb";
}

} // namespace

std::string progress_line(double share, double time, double seconds_left) {
  const int full = static_cast<int>(bar_width * std::clamp(share, 0.0, 1.0));
  return fmt::format("[{:#>{}}{:.>{}}] {:3.0f} %  t = {:.4g} s  {:.0f} s left", "", full, "", bar_width - full,
                     100 * share, time, seconds_left);
}

RunProgress::RunProgress(double done) : shown_(is_terminal()), done_(done), start_(Clock::now()), next_(start_) {}

RunProgress::~RunProgress() {
  if (shown_)
    fmt::print(stderr, "{}", back_to_an_empty_line);
}

void RunProgress::show(double share, double time) {
  if (!shown_ || share <= done_)
    return;
  const auto now = Clock::now();
  if (now < next_)
    return;
  next_ = now + between;
  const double past = std::chrono::duration<double>(now - start_).count();
  fmt::print(stderr, "{}{}", back_to_an_empty_line, progress_line(share, time, past * (1 - share) / (share - done_)));
}

} // namespace pfv
