// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"

namespace galilean::front {

/// A child process. The destructor ends it, and the kernel sends it SIGTERM when the thread that
/// started it ends, even by a crash. Ctrl-C in the terminal does not reach it, so that its owner
/// decides when it ends.
class Process {
 public:
  /// Starts a program. `command` is its path and arguments. Its standard output and standard error
  /// are appended to `log`, which its owner alone may read. If the program cannot be executed, it
  /// ends with exit code 127. Requires: the calling thread outlives the process. Errors: the log
  /// cannot be written, or the process cannot be made.
  [[nodiscard]] static Result<Process> start(std::string name,
                                             const std::vector<std::string>& command,
                                             const std::filesystem::path& log);
  Process(Process&& other) noexcept;
  Process& operator=(Process&&) = delete;
  ~Process();

  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  [[nodiscard]] const std::filesystem::path& log() const noexcept { return log_; }
  [[nodiscard]] pid_t pid() const noexcept { return pid_; }
  /// Returns false if the process has ended. Never waits.
  [[nodiscard]] bool running();
  /// Returns "exit code 1" or "killed by signal 9 (Killed)", or an empty string if `running` has
  /// not yet returned false.
  [[nodiscard]] std::string ending() const;
  /// Returns the exit code, or nothing if the process is not known to have ended by itself.
  [[nodiscard]] std::optional<int> exit_code() const noexcept;
  /// Returns whether the process is known to have ended with exit code 0.
  [[nodiscard]] bool ended_well() const noexcept;

  /// Sends SIGTERM, so that the process can end in order.
  void ask_to_end() noexcept;
  /// Waits until the process has ended, and kills it after 8 s. Returns false if it was killed.
  bool end();

 private:
  Process(std::string name, std::filesystem::path log, pid_t pid)
      : name_(std::move(name)), log_(std::move(log)), pid_(pid) {}

  std::string name_;
  std::filesystem::path log_;
  pid_t pid_;                  ///< 0 if this object was moved from
  std::optional<int> status_;  ///< waitpid's status, after the process has ended
};

/// Returns the last lines of a log, indented for display. Returns an empty string if there is no
/// log.
[[nodiscard]] std::string last_lines(const std::filesystem::path& log, std::size_t count);
/// Returns the first line of a log that contains `mark` and ends with a line feed, or nothing.
[[nodiscard]] std::optional<std::string> line_with(const std::filesystem::path& log,
                                                   std::string_view mark);

}  // namespace galilean::front
