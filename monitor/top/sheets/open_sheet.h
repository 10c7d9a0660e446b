// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "monitor/top/panels/sheet.h"
#include "monitor/top/screen/keys.h"

namespace galilean::monitor::top {

/// A sheet that lies over the dashboard and takes the keys until it closes.
class OpenSheet {
 public:
  /// What a key makes of the sheet.
  struct Turn {
    bool stays = true;
    std::unique_ptr<OpenSheet> next = {};  ///< takes this one's place; none: nothing does
  };

  virtual ~OpenSheet() = default;

  [[nodiscard]] virtual Turn press(const Press& press) = 0;
  /// Draws the sheet as it is now over the canvas' lower part, with a notice to the operator.
  void lay_over(const std::string& notice, Canvas& canvas) {
    Sheet shown = sheet();
    shown.scroll = scroll_;
    shown.notice = notice;
    top::lay_over(shown, canvas);
    scroll_ = shown.scroll;
  }

 protected:
  [[nodiscard]] virtual Sheet sheet() = 0;

  [[nodiscard]] static Turn stay() { return {}; }
  [[nodiscard]] static Turn close() { return {.stays = false}; }
  [[nodiscard]] static Turn turn_to(std::unique_ptr<OpenSheet> next) {
    return {.stays = false, .next = std::move(next)};
  }
  /// Returns -1 for a key that goes up, 1 for one that goes down, else 0.
  [[nodiscard]] static int direction_of(const Press& press) noexcept {
    const bool up = press.key == Key::kUp || press.key == Key::kWheelUp || press.letter == 'k';
    const bool down =
        press.key == Key::kDown || press.key == Key::kWheelDown || press.letter == 'j';
    return up ? -1 : down ? 1 : 0;
  }
  void scroll(int lines) noexcept { scroll_ += lines; }

 private:
  int scroll_ = 0;
};

}  // namespace galilean::monitor::top
