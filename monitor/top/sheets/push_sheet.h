// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monitor/top/push/pusher.h"
#include "monitor/top/sheets/open_sheet.h"

namespace galilean::monitor::top {

/// Shows the check of a program, asks whether to push it, and shows how far the push is.
class PushSheet : public OpenSheet {
 public:
  /// Shows the push that is under way. Requires: `pusher` outlives this.
  explicit PushSheet(Pusher& pusher) : pusher_(pusher) {}
  /// Checks a program.
  PushSheet(Pusher& pusher, PushWish wish);

  [[nodiscard]] Turn press(const Press& press) override;

 protected:
  [[nodiscard]] Sheet sheet() override;

 private:
  using Stage = PushReport::Stage;

  [[nodiscard]] std::string keys_at(Stage stage) const;

  Pusher& pusher_;
  PushWish wish_;
  bool with_canary_ = false;
};

}  // namespace galilean::monitor::top
