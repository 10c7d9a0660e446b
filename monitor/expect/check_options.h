// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace galilean::expect {

/// What `galilean log check` is asked for.
struct CheckOptions {
  std::string recording;
  std::vector<std::string> expectations;
  std::string format = "text";
  std::string junit;
  std::vector<std::string> problems;   ///< what is reported beside the expectations
  std::vector<std::string> shortages;  ///< why the recording is not whole, which is reported, too
  double silence_s = 2;
  bool syntax = false;  ///< only read the expectations
  bool live = false;
  std::optional<double> for_s;  ///< live: nothing for "until termination is asked for"
  int domain = -1;
};

/// Reads the options. Returns nothing if the program is to go on, and the exit code otherwise.
[[nodiscard]] std::optional<int> read_check_options(int count, const char* const* arguments,
                                                    CheckOptions& options);

}  // namespace galilean::expect
