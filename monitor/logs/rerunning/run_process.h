// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/result.h"

namespace galilean::logs {

/// A process that gets messages on its standard input, each behind its length in four bytes, the
/// least first. What it prints goes where this process prints.
class RunProcess {
 public:
  /// Errors: it cannot be started.
  [[nodiscard]] static Result<std::unique_ptr<RunProcess>> start(
      const std::vector<std::string>& command);
  /// Ends its input and waits for its end.
  ~RunProcess();
  RunProcess(const RunProcess&) = delete;
  RunProcess& operator=(const RunProcess&) = delete;

  /// Sends a message, and waits while the process has too many. Does nothing once the process does
  /// not read any more. Requires: SIGPIPE is ignored.
  void send(std::span<const std::uint8_t> message);
  /// Ends its input and waits for its end. Returns its exit code. Errors: a signal ended it.
  [[nodiscard]] Result<int> finish();

 private:
  RunProcess(pid_t pid, int input) : pid_(pid), input_(input) {}
  void write_all(std::span<const std::uint8_t> bytes);
  void end_input();

  pid_t pid_;  ///< 0 after its end
  int input_;  ///< -1 once it is closed
};

}  // namespace galilean::logs
