// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace galilean {

/// Turns SIGINT, SIGTERM and SIGHUP (unless that is ignored, as nohup has it) into something to
/// wait for, so that a program ends in order. Make it before the first other thread: those inherit
/// that the signals are blocked. Processes started while it lives inherit that too: see `unblock`.
class Termination {
 public:
  Termination();
  ~Termination();
  Termination(const Termination&) = delete;
  Termination& operator=(const Termination&) = delete;

  /// Returns a file descriptor for poll, which becomes readable once a signal came.
  [[nodiscard]] int descriptor() const noexcept { return descriptor_; }
  /// Returns whether a signal came. Never waits.
  [[nodiscard]] bool asked() noexcept;
  /// Unblocks the signals in a process that was just forked, so that the program that it executes
  /// receives them. May be called between fork and exec.
  static void unblock() noexcept;

 private:
  int descriptor_;
  bool asked_ = false;
};

}  // namespace galilean
