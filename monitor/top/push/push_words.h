// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "monitor/top/push/pusher.h"

namespace galilean::monitor::top {

// These put a monitor's answers into words. All may throw if the JSON is not as
// docs/openapi.yaml says.

/// Of POST /api/check.
[[nodiscard]] PushReport report_of_check(const nlohmann::json& answer, const std::string& file);
/// Of POST /api/push and GET /api/pushes/ID.
[[nodiscard]] PushReport report_of_push(const nlohmann::json& answer);
/// Of an answer that is an error, with the sentence that says why.
[[nodiscard]] PushReport report_of_refusal(const nlohmann::json& answer, const std::string& why);
/// Of GET /api/pushes.
[[nodiscard]] std::vector<PastPush> past_pushes(const nlohmann::json& answer);
/// Of a monitor that stopped answering during the push that `before` tells of.
[[nodiscard]] PushReport report_of_silence(const PushReport& before, const std::string& why);

}  // namespace galilean::monitor::top
