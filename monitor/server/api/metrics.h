// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "monitor/ingest/intake.h"
#include "monitor/map/map_service.h"
#include "monitor/pushes/history_watch.h"
#include "monitor/server/foxglove/foxglove_hub.h"
#include "monitor/server/http/http_server.h"
#include "monitor/server/limits/limit_counts.h"
#include "monitor/team/team.h"

namespace galilean::monitor {

/// Returns the metrics in Prometheus' text format 0.0.4.
[[nodiscard]] std::string metrics_text(const Team& team, const foxglove::Hub::Counts& websocket,
                                       const HttpServer::Counts& http, const Intake& intake,
                                       const LimitCounts& limit_counts, const MapService& map,
                                       const HistoryWatch& history);

}  // namespace galilean::monitor
