// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/screen/last_wish.h"

#include <signal.h>
#include <unistd.h>

#include <array>

namespace galilean::monitor::top {
namespace {

constexpr std::array kDeadly{SIGABRT, SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGQUIT};

termios mode_before{};
std::string_view last_bytes;

/// Calls only what may be called in a signal's handler. The handler was removed as it was called,
/// so the signal that is raised again ends the process.
void give_back(int signal) {
  [[maybe_unused]] const auto written =
      ::write(STDOUT_FILENO, last_bytes.data(), last_bytes.size());
  tcsetattr(STDIN_FILENO, TCSANOW, &mode_before);
  raise(signal);
}

void on_deadly_signals(void (*handler)(int)) noexcept {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int signal : kDeadly) sigaction(signal, &action, nullptr);
}

}  // namespace

void LastWish::arm(const termios& mode, std::string_view bytes) noexcept {
  mode_before = mode;
  last_bytes = bytes;
  on_deadly_signals(give_back);
}

void LastWish::disarm() noexcept {
  on_deadly_signals(SIG_DFL);
}

}  // namespace galilean::monitor::top
