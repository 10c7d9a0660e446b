// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>
#include <vector>

namespace galilean::monitor {

/// What a key asks of a replay.
enum class ReplayKey { kPause, kStep, kFaster, kSlower, kForward, kBack, kBegin, kEnd };

/// Returns what the keys ask for whose bytes a terminal sent. Other keys ask for nothing.
[[nodiscard]] std::vector<ReplayKey> keys_in(std::string_view bytes);

}  // namespace galilean::monitor
