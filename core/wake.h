// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace galilean {

/// Lets other threads wake a thread that waits in poll.
class Wake {
 public:
  Wake();
  ~Wake();
  Wake(const Wake&) = delete;
  Wake& operator=(const Wake&) = delete;

  void ring() noexcept;   ///< Makes `descriptor` readable. Any thread may call it.
  void clear() noexcept;  ///< Call it before looking for work, so that no ring is lost.
  /// Returns a file descriptor for poll. It is readable from `ring` until `clear`.
  [[nodiscard]] int descriptor() const noexcept { return descriptor_; }

 private:
  int descriptor_;
};

}  // namespace galilean
