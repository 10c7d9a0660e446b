#pragma once

namespace galilean {

/// Turns SIGINT and SIGTERM into something to wait for, so that a program ends in order. Make it
/// before the first other thread: those inherit that the two signals are blocked. Processes started
/// while it lives inherit that too, and must unblock them.
class Termination {
 public:
  Termination();
  ~Termination();
  Termination(const Termination&) = delete;
  Termination& operator=(const Termination&) = delete;

  /// Readable once one of the two came: for poll.
  [[nodiscard]] int descriptor() const noexcept { return descriptor_; }
  /// Whether one came. Never waits.
  [[nodiscard]] bool asked() noexcept;

 private:
  int descriptor_;
  bool asked_ = false;
};

}  // namespace galilean
