// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace galilean::monitor::top {

/// Turns Ctrl-Z (SIGTSTP) and `fg` (SIGCONT) into something to wait for, so that the terminal can
/// be given back before the process stops. Make it before the first other thread: later threads
/// inherit that the signals are blocked.
class JobControl {
 public:
  JobControl();
  ~JobControl();
  JobControl(const JobControl&) = delete;
  JobControl& operator=(const JobControl&) = delete;

  enum class Event { kNone, kStop, kContinued };
  /// Returns a file descriptor for poll, which becomes readable once a signal came.
  [[nodiscard]] int descriptor() const noexcept { return descriptor_; }
  /// Returns what came first since the last call. It never waits.
  [[nodiscard]] Event take() noexcept;
  /// Stops the process until it is continued. Does nothing where no shell could continue it.
  static void stop() noexcept;

 private:
  int descriptor_;
};

}  // namespace galilean::monitor::top
