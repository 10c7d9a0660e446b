// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bhdl/check.h"
#include "core/result.h"
#include "monitor/pushes/history/order_record.h"
#include "monitor/pushes/history/push_record.h"

namespace galilean::monitor {

/// {robot, status, message, hash, running_hash, diagnostics, kept_variables, swap_tick_us,
/// latency_ms}
[[nodiscard]] nlohmann::json to_json(const RobotReply& reply);
[[nodiscard]] nlohmann::json to_json(const std::vector<RobotReply>& replies);
/// {name, state, detail}
[[nodiscard]] nlohmann::json to_json(const Step& step);
/// {id, pushed_ns, author, program, hash, targets, state, told_ns, steps, trial, replies}, and
/// not_kept if there is such a reason
[[nodiscard]] nlohmann::json to_json(const PushRecord& record);
/// {id, ordered_ns, author, kind, targets, detail, outcomes: [{of, outcome, told_ns}]}
[[nodiscard]] nlohmann::json to_json(const OrderRecord& order);
/// {ok, hash, diagnostics, machine}
[[nodiscard]] nlohmann::json to_json(const bhdl::CheckResult& check);
[[nodiscard]] nlohmann::json to_json(const std::vector<bhdl::SourceFile>& files);

/// Reads [{path, text}] with at least one file. Errors: the list is not so; the message calls it
/// `name`.
[[nodiscard]] Result<std::vector<bhdl::SourceFile>> files_from_json(
    const nlohmann::json& json, const std::string& name = "files");

}  // namespace galilean::monitor
