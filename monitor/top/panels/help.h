// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monitor/top/panels/sheet.h"

namespace galilean::monitor::top {

/// Returns the sheet that explains the keys.
[[nodiscard]] Sheet help_sheet();

}  // namespace galilean::monitor::top
