// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/screen/terminal.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string_view>

#include "monitor/top/screen/encoder.h"
#include "monitor/top/screen/last_wish.h"

namespace galilean::monitor::top {
namespace {

// The other screen, no cursor, no line wrap; back in the opposite order.
constexpr std::string_view kEnter = "\x1b[?1049h\x1b[?25l\x1b[?7l";
constexpr std::string_view kMouseOn = "\x1b[?1000h\x1b[?1006h";
constexpr std::string_view kLeave = "\x1b[?1006l\x1b[?1000l\x1b[?7h\x1b[0m\x1b[?25h\x1b[?1049l";

/// Opens the terminal once more, so that writing to it does not wait and the shell's own
/// descriptor stays as it is. Returns standard output if that fails.
int open_without_waiting() {
  const int opened = ::open("/proc/self/fd/1", O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  return opened >= 0 ? opened : STDOUT_FILENO;
}

/// Sets the terminal's mode, also from the background, where that would stop the process.
void set_mode(const termios& mode) noexcept {
  sigset_t stopping, before;
  sigemptyset(&stopping);
  sigaddset(&stopping, SIGTTOU);
  pthread_sigmask(SIG_BLOCK, &stopping, &before);
  tcsetattr(STDIN_FILENO, TCSANOW, &mode);
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

/// Returns whether the terminal's keys go to this process, and not to a shell that keeps it in the
/// background.
bool is_in_foreground() noexcept {
  return tcgetpgrp(STDIN_FILENO) == getpgrp();
}

termios mode_for_keys(termios mode) {
  mode.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  mode.c_iflag &= ~static_cast<tcflag_t>(IXON);
  mode.c_cc[VMIN] = 1;
  mode.c_cc[VTIME] = 0;
  return mode;
}

/// Returns how many bytes the terminal took, without waiting. Returns all if it is gone.
std::size_t write_some(int descriptor, std::string_view bytes) noexcept {
  while (true) {
    const auto written = ::write(descriptor, bytes.data(), bytes.size());
    if (written >= 0) return static_cast<std::size_t>(written);
    if (errno == EAGAIN) return 0;
    if (errno != EINTR) return bytes.size();
  }
}

}  // namespace

Result<void> Terminal::check(const Environment& environment) {
  constexpr const char* kInstead = "; --once prints one snapshot as text instead";
  if (!isatty(STDIN_FILENO))
    return Error{std::string("the keys are read from standard input, which is not a terminal") +
                 kInstead};
  if (!isatty(STDOUT_FILENO))
    return Error{std::string("the team is drawn on standard output, which is not a terminal") +
                 kInstead};
  const std::string type = environment("TERM");
  if (type.empty() || type == "dumb")
    return Error{"a terminal of type '" + type + "' cannot be drawn on (see TERM)" + kInstead};
  return {};
}

Terminal::Terminal(const Look& look, bool mouse)
    : look_(look), mouse_(mouse), output_(open_without_waiting()) {
  tcgetattr(STDIN_FILENO, &before_);
  enter();
}

Terminal::~Terminal() {
  leave();
  if (output_ != STDOUT_FILENO) ::close(output_);
}

void Terminal::measure() {
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0 || size.ws_row == 0) return;
  columns_ = size.ws_col;
  rows_ = size.ws_row;
}

void Terminal::enter() {
  if (!is_in_foreground()) return;
  if (!entered_) LastWish::arm(before_, kLeave);
  entered_ = true;
  set_mode(mode_for_keys(before_));
  unsent_ = std::string(kEnter) + std::string(mouse_ ? kMouseOn : "");
  shown_.reset();
  measure();
}

void Terminal::leave() noexcept {
  if (!entered_) return;
  entered_ = false;
  if (!is_in_foreground()) {
    unsent_.clear();
    return LastWish::disarm();
  }
  constexpr int kMostWait_ms = 200;
  pollfd event{output_, POLLOUT, 0};
  for (std::string_view rest = kLeave; !rest.empty();) {
    if (::poll(&event, 1, kMostWait_ms) <= 0) break;
    rest.remove_prefix(write_some(output_, rest));
  }
  unsent_.clear();
  set_mode(before_);
  tcflush(STDIN_FILENO, TCIFLUSH);
  LastWish::disarm();
}

void Terminal::show(const Canvas& canvas) {
  if (!entered_) return;
  flush();
  if (is_behind()) return;
  unsent_ = changes(shown_ ? &*shown_ : nullptr, canvas, look_);
  shown_ = canvas;
  flush();
}

void Terminal::flush() {
  while (is_behind()) {
    const std::size_t taken = write_some(output_, unsent_);
    if (taken == 0) return;
    unsent_.erase(0, taken);
  }
}

bool Terminal::read_keys() {
  std::array<char, 512> bytes;
  const auto count = ::read(STDIN_FILENO, bytes.data(), bytes.size());
  if (count > 0) keys_.feed({bytes.data(), static_cast<std::size_t>(count)});
  return count > 0 || (count < 0 && (errno == EINTR || errno == EAGAIN));
}

Press Terminal::take_key() {
  constexpr int kRest_ms = 25;
  const Press press = keys_.take(false);
  if (press.key != Key::kNone || !keys_.is_pending()) return press;
  pollfd event{STDIN_FILENO, POLLIN, 0};
  const bool more = ::poll(&event, 1, kRest_ms) > 0 && read_keys();
  return keys_.take(!more);
}

}  // namespace galilean::monitor::top
