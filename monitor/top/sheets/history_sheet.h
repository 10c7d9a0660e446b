// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monitor/top/push/pusher.h"
#include "monitor/top/sheets/open_sheet.h"

namespace galilean::monitor::top {

/// Lists what was pushed through the monitor. Enter shows how the chosen program differs from the
/// one that runs, and asks whether to push it again.
class HistorySheet : public OpenSheet {
 public:
  /// `wish` says to whom a program would go, and what runs there. Requires: `pusher` outlives this.
  HistorySheet(Pusher& pusher, PushWish wish);

  [[nodiscard]] Turn press(const Press& press) override;

 protected:
  [[nodiscard]] Sheet sheet() override;

 private:
  Pusher& pusher_;
  PushWish wish_;
  std::size_t chosen_ = 0;
};

}  // namespace galilean::monitor::top
