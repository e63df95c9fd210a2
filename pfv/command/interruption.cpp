#include "pfv/command/interruption.hpp"

#include <array>
#include <csignal>
#include <ctime>

namespace pfv {

namespace {

constexpr std::array signals{SIGINT, SIGTERM};

volatile std::sig_atomic_t received = 0;
volatile std::time_t received_at = 0; // s

extern "C" void keep(int signal) {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  if (received != 0 && now.tv_sec > received_at + 1) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
    return;
  }
  if (received == 0)
    received_at = now.tv_sec;
  received = signal;
}

} // namespace

Interruption::Interruption() {
  received = 0;
  struct sigaction action {};
  action.sa_handler = keep;
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
