// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace galilean {

/// Lets other threads wake one that polls.
class Wake {
 public:
  Wake();
  ~Wake();
  Wake(const Wake&) = delete;
  Wake& operator=(const Wake&) = delete;

  void ring() noexcept;   ///< from any thread
  void clear() noexcept;  ///< before looking for what it was rung for
  /// Readable while rung.
  [[nodiscard]] int descriptor() const noexcept { return descriptor_; }

 private:
  int descriptor_;
};

}  // namespace galilean
