// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>

namespace galilean::front {

/// Runs whose logs are kept, the newest.
inline constexpr std::size_t kKeptRuns = 10;

/// Removes the oldest of the folders run-* in `logs`, so that `kept` of them stay.
void forget_old_runs(const std::filesystem::path& logs, std::size_t kept);

}  // namespace galilean::front
