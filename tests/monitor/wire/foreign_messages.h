// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "monitor/wire/message_decoder.h"
#include "tests/core/wire/types/foreign_talk.h"

namespace galilean::monitor {

/// Returns the sample of a foreign message as Cyclone encodes it.
[[nodiscard]] std::vector<std::uint8_t> foreign_bytes(wire::Foreign message, wire::Cdr version);
/// Returns the type of a foreign message. Requires: it has type information.
[[nodiscard]] wire::Type foreign_description(wire::Foreign message);
/// Returns what the sample of a foreign message is decoded to, as JSON.
[[nodiscard]] std::string foreign_json(wire::Foreign message);

}  // namespace galilean::monitor
