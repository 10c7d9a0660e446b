// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace galilean::logs {

/// What `galilean log coverage` is asked for.
struct CoverageOptions {
  std::vector<std::string> files;
  std::string format = "text";          ///< "text", "json" or "dot"
  std::optional<double> least_percent;  ///< of states and of conditions; nothing: any share will do
};

/// Prints which states and conditions of their programs the robots of recordings exercised. Returns
/// the exit code.
[[nodiscard]] int print_coverage(const CoverageOptions& options);

}  // namespace galilean::logs
