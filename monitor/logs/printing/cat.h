// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "monitor/logs/reading/selection.h"

namespace galilean::logs {

/// What `galilean log cat` is asked for.
struct CatOptions {
  std::string file;
  Selection selection;
  std::string field;  ///< print this field alone; empty: the whole message
  bool json = false;
  int count = 0;  ///< end after so many messages; 0: no limit
};

/// Prints messages as text, or as JSON, one a line. Returns the exit code.
[[nodiscard]] int print_messages(const CatOptions& options);

}  // namespace galilean::logs
