// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/wire/endpoints.h"
#include "monitor/wire/message_decoder.h"

namespace galilean::monitor {

/// Returns what one side of a topic offers or asks for, in words.
[[nodiscard]] MessageTree qos_tree(const wire::EndpointQos& qos);
/// Returns the same on one line, without what is usual. Requires: `qos` comes from qos_tree.
[[nodiscard]] std::string qos_text(const MessageTree& qos);

/// Returns why the two ends of a topic cannot match, one sentence each. None: they match.
[[nodiscard]] std::vector<std::string> mismatches(const wire::EndpointInfo& writer,
                                                  const wire::EndpointInfo& reader);

}  // namespace galilean::monitor
