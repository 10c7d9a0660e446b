// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>

#include "core/wire/endpoints.h"
#include "monitor/wire/message_decoder.h"

namespace galilean::monitor {

using EndpointList = std::span<const wire::EndpointInfo>;

/// Returns the topics, ordered by name: topic, types, and how many write and read it.
[[nodiscard]] MessageTree topic_list(EndpointList endpoints);
[[nodiscard]] std::string topic_list_text(const MessageTree& list);

/// Returns who writes and reads one topic, with each side's QoS, and the pairs that cannot match.
/// Requires: all endpoints are of one topic, and there is one.
[[nodiscard]] MessageTree topic_info(EndpointList endpoints);
[[nodiscard]] std::string topic_info_text(const MessageTree& info);

/// Returns which process writes and reads which topics.
[[nodiscard]] MessageTree process_graph(EndpointList endpoints);
[[nodiscard]] std::string process_graph_text(const MessageTree& graph);
/// Returns the graph in Graphviz's language.
[[nodiscard]] std::string process_graph_dot(const MessageTree& graph);

}  // namespace galilean::monitor
