// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/wire/endpoints.h"
#include "monitor/wire/message_decoder.h"

namespace galilean::monitor {

/// Returns what one side of a topic offers or asks for, in words.
[[nodiscard]] MessageTree qos_tree(const wire::EndpointQos& qos);
/// Returns the same on one line, without what is usual. Requires: `qos` comes from qos_tree.
[[nodiscard]] std::string qos_text(const MessageTree& qos);

/// Returns what a reader of a topic asks for: the least that any of these ends offers or asks for,
/// so that it matches each of them that writes.
[[nodiscard]] wire::EndpointQos least_qos(std::span<const wire::EndpointInfo> ends);

/// Returns why the two ends of a topic cannot match, one sentence each. None: they match.
[[nodiscard]] std::vector<std::string> mismatches(const wire::EndpointInfo& writer,
                                                  const wire::EndpointInfo& reader);

}  // namespace galilean::monitor
