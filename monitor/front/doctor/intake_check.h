// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "monitor/front/doctor/checks.h"

namespace galilean::front {

/// Returns what a monitor's answer to GET /api/status says of the messages that it did not take: a
/// problem with topic, reason and count if there are any. Any JSON may be passed.
[[nodiscard]] Check intake_check(const nlohmann::json& status);

}  // namespace galilean::front
