// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monitor/top/panels/help.h"
#include "monitor/top/sheets/open_sheet.h"

namespace galilean::monitor::top {

/// Explains the keys.
class HelpSheet : public OpenSheet {
 public:
  [[nodiscard]] Turn press(const Press& press) override {
    const int lines = direction_of(press);
    scroll(lines);
    return lines != 0 || press.key == Key::kOther ? stay() : close();
  }

 protected:
  [[nodiscard]] Sheet sheet() override { return help_sheet(); }
};

}  // namespace galilean::monitor::top
