// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace galilean {

/// Turns SIGINT, SIGTERM and SIGHUP into something to wait for, so that a program ends in order.
/// SIGHUP is left alone if it is ignored, as nohup does. Make it before the first other thread:
/// later threads inherit that the signals are blocked. Processes started while it lives inherit
/// that too: see `unblock`.
class Termination {
 public:
  Termination();
  ~Termination();
  Termination(const Termination&) = delete;
  Termination& operator=(const Termination&) = delete;

  /// Returns a file descriptor for poll, which becomes readable once a signal came.
  [[nodiscard]] int descriptor() const noexcept { return descriptor_; }
  /// Returns whether a signal came. It never waits.
  [[nodiscard]] bool asked() noexcept;
  /// Unblocks the signals in a process that was just forked, so that the program that it executes
  /// receives them. It may be called between fork and exec.
  static void unblock() noexcept;

 private:
  int descriptor_;
  bool asked_ = false;
};

}  // namespace galilean
