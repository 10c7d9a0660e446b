// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/replay/key_terminal.h"

#include <unistd.h>

#include <algorithm>
#include <utility>

namespace galilean::monitor {
namespace {

constexpr std::pair<std::string_view, ReplayKey> kKeys[] = {
    {"\x1b[C", ReplayKey::kForward}, {"\x1b[D", ReplayKey::kBack}, {"\x1b[H", ReplayKey::kBegin},
    {" ", ReplayKey::kPause},        {".", ReplayKey::kStep},      {"+", ReplayKey::kFaster},
    {"=", ReplayKey::kFaster},       {"-", ReplayKey::kSlower},    {"q", ReplayKey::kEnd},
};

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

std::vector<ReplayKey> keys_in(std::string_view bytes) {
  std::vector<ReplayKey> keys;
  while (!bytes.empty()) {
    const auto key = bytes.substr(0, length_of_key(bytes));
    for (const auto& [sequence, meaning] : kKeys)
      if (key == sequence) keys.push_back(meaning);
    bytes.remove_prefix(key.size());
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

std::vector<ReplayKey> KeyTerminal::read() {
  char bytes[64];
  if (!before_ || !in_foreground()) return {};
  const auto count = ::read(STDIN_FILENO, bytes, sizeof bytes);
  return count > 0 ? keys_in({bytes, static_cast<std::size_t>(count)}) : std::vector<ReplayKey>();
}

}  // namespace galilean::monitor
