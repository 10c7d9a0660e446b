// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "core/wire/messages.h"

namespace galilean::monitor {

/// Return the JSON that `galilean sim ctl --json` prints. Its members are called as the message's
/// fields.
[[nodiscard]] nlohmann::json to_json(const msg::SimulationState& state);
[[nodiscard]] nlohmann::json to_json(const msg::SimulationEvent& event);

}  // namespace galilean::monitor
