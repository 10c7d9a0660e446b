// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>

#include "monitor/ingest/intake.h"

namespace galilean::monitor {

/// Returns each channel with its number of messages and the newest one's age, which is null before
/// the first; and of robots' events, how many fill a gap and how many are lost.
[[nodiscard]] nlohmann::json channels_json(const Intake& intake);
/// Returns the messages that were not taken, by topic and reason.
[[nodiscard]] nlohmann::json refused_json(const Intake& intake);

}  // namespace galilean::monitor
