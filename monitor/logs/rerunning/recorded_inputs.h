// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/result.h"
#include "monitor/logs/reading/recording.h"

namespace galilean::logs {

/// The end of the topic on which a robot tells what its ticks read.
inline constexpr const char* kInputs = "/inputs";

using Recordings = std::vector<std::unique_ptr<Recording>>;

/// Checks the robots that are asked for. Errors: the recordings have inputs of robots, and none of
/// one of these; the message says whose there are.
[[nodiscard]] Result<void> check_robots(const std::vector<std::string>& robots,
                                        const Recordings& recordings);

}  // namespace galilean::logs
