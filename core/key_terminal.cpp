// SPDX-License-Identifier: BSD-3-Clause
#include "core/key_terminal.h"

#include <unistd.h>

#include <algorithm>

namespace galilean {
namespace {

/// A process in the background that reads from its terminal, or changes it, is stopped.
bool in_foreground() {
  return isatty(STDIN_FILENO) != 0 && tcgetpgrp(STDIN_FILENO) == getpgrp();
}

/// Returns how many bytes the key at the beginning has: a letter, or an escape sequence.
std::size_t length_of_key(std::string_view bytes) {
  if (!bytes.starts_with("\x1b[")) return 1;
  std::size_t length = 2;
  while (length < bytes.size() && (bytes[length] < '@' || bytes[length] > '~')) ++length;
  return std::min(length + 1, bytes.size());
}

}  // namespace

std::vector<std::string_view> split_keys(std::string_view bytes) {
  std::vector<std::string_view> keys;
  while (!bytes.empty()) {
    keys.push_back(bytes.substr(0, length_of_key(bytes)));
    bytes.remove_prefix(keys.back().size());
  }
  return keys;
}

KeyTerminal::KeyTerminal() {
  termios mode{};
  if (!in_foreground() || tcgetattr(STDIN_FILENO, &mode) != 0) return;
  before_ = mode;
  mode.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  mode.c_cc[VMIN] = 0;  // read never waits
  mode.c_cc[VTIME] = 0;
  tcsetattr(STDIN_FILENO, TCSANOW, &mode);
}

KeyTerminal::~KeyTerminal() {
  if (before_ && in_foreground()) tcsetattr(STDIN_FILENO, TCSANOW, &*before_);
}

int KeyTerminal::descriptor() const noexcept {
  return before_ && in_foreground() ? STDIN_FILENO : -1;
}

std::string KeyTerminal::read() {
  char bytes[64];
  if (!before_ || !in_foreground()) return {};
  const auto count = ::read(STDIN_FILENO, bytes, sizeof bytes);
  return count > 0 ? std::string(bytes, static_cast<std::size_t>(count)) : std::string();
}

}  // namespace galilean
