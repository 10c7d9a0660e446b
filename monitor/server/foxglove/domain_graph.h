// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/wire/graph.h"
#include "core/wire/topic_names.h"
#include "monitor/server/foxglove/foxglove_messages.h"

namespace galilean::monitor {

/// Returns the writers and readers of the domain's ROS topics as Foxglove's connection graph.
/// Topics without ROS' prefix "rt/" are left out.
[[nodiscard]] inline foxglove::ConnectionGraph connection_graph(const wire::Graph::Topics& topics) {
  constexpr std::string_view kRosTopic = "rt/";
  foxglove::ConnectionGraph graph;
  for (const auto& [topic, ends] : topics) {
    if (!topic.starts_with(kRosTopic)) continue;
    const auto name = topic.substr(kRosTopic.size() - 1);
    if (!ends.writers.empty()) graph.published[name] = ends.writers;
    if (!ends.readers.empty()) graph.subscribed[name] = ends.readers;
  }
  return graph;
}

}  // namespace galilean::monitor
