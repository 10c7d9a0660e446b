// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"

namespace galilean::front {

/// Another program, started by this one. It ends when this object goes, and when this process does,
/// however that happens. Ctrl-C in the terminal does not reach it: who started it decides when it
/// ends.
class Process {
 public:
  /// `log` takes all that it prints. Start it from a thread that outlives it.
  [[nodiscard]] static Result<Process> start(std::string name,
                                             const std::vector<std::string>& command,
                                             const std::filesystem::path& log);
  Process(Process&& other) noexcept;
  Process& operator=(Process&&) = delete;
  ~Process();

  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  [[nodiscard]] const std::filesystem::path& log() const noexcept { return log_; }
  [[nodiscard]] pid_t pid() const noexcept { return pid_; }
  /// False once it has ended. Never waits.
  [[nodiscard]] bool running();
  /// "exit code 1" or "killed by signal 9 (Killed)"; empty while it runs.
  [[nodiscard]] std::string ending() const;
  [[nodiscard]] bool ended_well() const noexcept;

  /// SIGTERM, which lets it end in order.
  void ask_to_end() noexcept;
  /// Waits until it has ended, and makes it after some seconds. False if it had to be made.
  bool end();

 private:
  Process(std::string name, std::filesystem::path log, pid_t pid)
      : name_(std::move(name)), log_(std::move(log)), pid_(pid) {}

  std::string name_;
  std::filesystem::path log_;
  pid_t pid_;                  ///< 0: moved away
  std::optional<int> status_;  ///< of waitpid, once it has ended
};

/// The last lines of a log, for people; empty if there is none.
[[nodiscard]] std::string last_lines(const std::filesystem::path& log, std::size_t count);
/// The first whole line of a log that contains `mark`.
[[nodiscard]] std::optional<std::string> line_with(const std::filesystem::path& log,
                                                   std::string_view mark);

}  // namespace galilean::front
