// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace galilean::monitor {

/// What somebody may do. A greater right includes the smaller ones.
enum class Right { kNone, kRead, kOperate };

}  // namespace galilean::monitor
