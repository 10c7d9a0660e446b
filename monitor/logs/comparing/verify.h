// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace galilean::logs {

/// What `galilean log verify` is asked for.
struct VerifyOptions {
  std::vector<std::string> files;
  bool json = false;
};

/// Reads recordings whole, compares every checksum, and decodes every message. Prints what is wrong
/// with each. Returns the exit code.
[[nodiscard]] int verify_recordings(const VerifyOptions& options);

}  // namespace galilean::logs
