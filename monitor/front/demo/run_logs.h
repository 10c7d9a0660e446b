// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>

namespace galilean::front {

/// The number of runs whose logs are kept.
inline constexpr std::size_t kKeptRuns = 10;

/// Removes the folders run-* in `logs` but for the `kept` newest ones. Ignores what it cannot
/// remove.
void forget_old_runs(const std::filesystem::path& logs, std::size_t kept);

}  // namespace galilean::front
