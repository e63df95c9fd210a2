#include "pfv/command/interruption.hpp"

#include <array>
#include <csignal>

namespace pfv {

namespace {

constexpr std::array signals{SIGINT, SIGTERM};

volatile std::sig_atomic_t received = 0;

extern "C" void keep(int signal) {
  received = signal;
}

} // namespace

Interruption::Interruption() {
  received = 0;
  struct sigaction action {};
  action.sa_handler = keep;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int signal : signals)
    sigaction(signal, &action, nullptr);
}

Interruption::~Interruption() {
  for (const int signal : signals)
    std::signal(signal, SIG_DFL);
}

int Interruption::signal() const {
  return received;
}

} // namespace pfv
