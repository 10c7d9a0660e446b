// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "monitor/logs/reading/recording.h"

namespace galilean::logs {

/// Returns a sentence, without a full stop, on each topic that only one of two recordings has, or
/// that has another type or definition in the other.
[[nodiscard]] std::vector<std::string> channel_differences(const Recording& first,
                                                           const Recording& second);

}  // namespace galilean::logs
