// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monitor/logs/reading/selection.h"

namespace galilean::logs {

/// What `galilean log diff` is asked for.
struct DiffOptions {
  std::string first, second;
  std::vector<std::string> topics;  ///< none: all
  bool json = false;
};

/// The exit code if two recordings cannot be compared.
inline constexpr int kNotComparable = 2;

/// Prints what two recordings differ in. Returns the exit code: kFailed if they differ.
[[nodiscard]] int print_difference(const DiffOptions& options);

}  // namespace galilean::logs
