// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/map_teller.h"

#include "core/wire/topic_names.h"
#include "monitor/team/monitor_status.h"

namespace galilean::monitor {

MapTeller::MapTeller(const MapService& map, Worker& sender, const Clock& clock,
                     wire::Participant& participant)
    : map_(map),
      sender_(sender),
      clock_(clock),
      diagnostics_(participant, wire::kDiagnosticsTopic) {}

void MapTeller::tell() {
  const Time now = clock_.now();
  if (now < due_) return;
  due_ = now + kPeriod;
  sender_.run([this, message = monitor_status(kMapStatusName, map_.watch().problem(),
                                              "The map takes in what comes.")] {
    (void)diagnostics_.write(message);
  });
}

}  // namespace galilean::monitor
