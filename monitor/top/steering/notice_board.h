// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>

#include "core/clock.h"

namespace galilean::monitor::top {

/// The newest sentence for the operator, which is shown for some seconds.
class NoticeBoard {
 public:
  static constexpr Duration kShown = std::chrono::seconds(4);

  /// Requires: `clock` outlives this.
  explicit NoticeBoard(const Clock& clock) : clock_(clock) {}

  void tell(std::string notice) {
    notice_ = std::move(notice);
    told_ = clock_.now();
  }
  /// Returns an empty string once the sentence has been shown long enough.
  [[nodiscard]] std::string shown() const {
    return clock_.now() - told_ < kShown ? notice_ : std::string();
  }

 private:
  const Clock& clock_;
  std::string notice_;
  Time told_{};
};

}  // namespace galilean::monitor::top
