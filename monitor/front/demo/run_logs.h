// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace galilean::front {

/// The number of runs whose logs are kept.
inline constexpr std::size_t kKeptRuns = 10;

/// Returns the path of a folder in `logs` that is not there yet: of that name, or with a number
/// behind it. In a container processes have the same ids again and again.
[[nodiscard]] std::filesystem::path new_run(const std::filesystem::path& logs,
                                            const std::string& name);

/// Removes the folders run-* in `logs` but for the `kept` newest ones. Ignores what it cannot
/// remove.
void forget_old_runs(const std::filesystem::path& logs, std::size_t kept);

}  // namespace galilean::front
