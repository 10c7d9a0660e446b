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

  void tell(std::string notice) { tell(std::move(notice), false); }
  /// Tells what was ordered or answered. That is of the present, whatever instant is shown.
  void tell_of_now(std::string notice) { tell(std::move(notice), true); }
  /// Returns an empty string once the sentence has been shown long enough. Where the past is shown,
  /// a sentence of the present says that it is.
  [[nodiscard]] std::string shown(bool is_past) const {
    if (clock_.now() - told_ >= kShown) return {};
    return (is_past && is_of_now_ ? "now: " : "") + notice_;
  }

 private:
  void tell(std::string notice, bool is_of_now) {
    notice_ = std::move(notice);
    is_of_now_ = is_of_now;
    told_ = clock_.now();
  }

  const Clock& clock_;
  std::string notice_;
  bool is_of_now_ = false;
  Time told_{};
};

}  // namespace galilean::monitor::top
