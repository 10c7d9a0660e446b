// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "monitor/ingest/intake.h"
#include "monitor/pushes/history_watch.h"
#include "monitor/server/foxglove/foxglove_hub.h"
#include "monitor/server/http/http_server.h"
#include "monitor/server/limits/limit_counts.h"
#include "monitor/team/team.h"

namespace galilean::monitor {

/// Returns the metrics in Prometheus' text format 0.0.4. `map_update_s` is how long the map's last
/// update took.
[[nodiscard]] std::string metrics_text(const Team& team, const foxglove::Hub::Counts& websocket,
                                       const HttpServer::Counts& http, const Intake& intake,
                                       const LimitCounts& limit_counts, double map_update_s,
                                       const HistoryWatch& history);

}  // namespace galilean::monitor
