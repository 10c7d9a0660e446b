// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/replay/replay_keys.h"

#include <utility>

#include "core/key_terminal.h"

namespace galilean::monitor {
namespace {

constexpr std::pair<std::string_view, ReplayKey> kKeys[] = {
    {"\x1b[C", ReplayKey::kForward}, {"\x1b[D", ReplayKey::kBack}, {"\x1b[H", ReplayKey::kBegin},
    {" ", ReplayKey::kPause},        {".", ReplayKey::kStep},      {"+", ReplayKey::kFaster},
    {"=", ReplayKey::kFaster},       {"-", ReplayKey::kSlower},    {"q", ReplayKey::kEnd},
};

}  // namespace

std::vector<ReplayKey> keys_in(std::string_view bytes) {
  std::vector<ReplayKey> keys;
  for (const auto key : split_keys(bytes))
    for (const auto& [sequence, meaning] : kKeys)
      if (key == sequence) keys.push_back(meaning);
  return keys;
}

}  // namespace galilean::monitor
