// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "monitor/logs/reading/selection.h"

namespace galilean::logs {

/// What `galilean log csv` is asked for.
struct CsvOptions {
  std::string file;
  std::string topic;                ///< empty: the only one
  std::vector<std::string> fields;  ///< none: all
  double from_s = 0;
  std::optional<double> to_s;
};

/// Prints a topic's messages as comma-separated values (RFC 4180), one a line, with a header. It
/// reads the recording twice, since lists may grow and each of their values is a column. Returns
/// the exit code.
[[nodiscard]] int print_csv(const CsvOptions& options);

}  // namespace galilean::logs
