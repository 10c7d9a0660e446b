// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "monitor/mcap/mcap_reader.h"
#include "monitor/record/pause_log.h"

namespace galilean::monitor {

/// Returns the pauses that a recording tells of and that lie within its time, the earliest first.
/// One that does not end was going on when the recorder broke off. Messages are read only if the
/// recorder told of pauses and did not come to its end.
[[nodiscard]] std::vector<Pause> told_pauses(const mcap::ByteSource& source,
                                             const mcap::Summary& summary);

}  // namespace galilean::monitor
