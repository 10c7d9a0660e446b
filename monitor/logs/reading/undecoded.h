// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include "monitor/schemas/message_trees.h"

namespace galilean::logs {

/// Counts messages that cannot be decoded, and says so once for each topic and reason.
class Undecoded {
 public:
  explicit Undecoded(std::string program) : program_(std::move(program)) {}

  void add(const std::string& topic, const std::string& reason);
  /// Prints what was counted on standard error. Returns the exit code: kIncomplete if anything was,
  /// else 0.
  [[nodiscard]] int finish() const;

 private:
  std::string program_;
  std::map<std::pair<std::string, std::string>, std::uint64_t> counts_;  ///< by topic and reason
};

}  // namespace galilean::logs
