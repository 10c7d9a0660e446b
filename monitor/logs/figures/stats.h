// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monitor/logs/reading/selection.h"

namespace galilean::logs {

/// What `galilean log stats` is asked for.
struct StatsOptions {
  std::string file;
  Selection selection;
  std::vector<std::string> fields;  ///< of the messages of the only topic that is wanted
  bool json = false;
};

/// Prints how often, how evenly, how large and how late each topic's messages came, and what the
/// values of fields are. Returns the exit code.
[[nodiscard]] int print_statistics(const StatsOptions& options);

}  // namespace galilean::logs
