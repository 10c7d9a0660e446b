// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <vector>

#include "core/wire/neighbours.h"
#include "monitor/replay/tracks.h"

namespace galilean::monitor {

/// Returns those that write the recording's topics in the domain. A replay would mix its messages
/// with theirs.
/// Those of a Stage of this process count as played.
[[nodiscard]] wire::Neighbours namesakes(const std::vector<wire::EndpointInfo>& endpoints,
                                         const std::map<std::uint16_t, Track>& tracks);

}  // namespace galilean::monitor
