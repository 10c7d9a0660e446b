// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/clock.h"
#include "core/wire/messages.h"
#include "core/wire/participant.h"
#include "core/wire/writer.h"
#include "monitor/background/worker.h"
#include "monitor/map/map_service.h"

namespace galilean::monitor {

/// Tells on /diagnostics how the map is, for whoever watches without the monitor's page. The map
/// itself cannot, where it stands still. For use on the io_context's thread.
class MapTeller {
 public:
  static constexpr Duration kPeriod = std::chrono::milliseconds(500);

  /// Requires: all of them outlive this.
  MapTeller(const MapService& map, Worker& sender, const Clock& clock,
            wire::Participant& participant);
  /// Tells it, unless it was told less than kPeriod ago.
  void tell();

 private:
  const MapService& map_;
  Worker& sender_;
  const Clock& clock_;
  wire::Writer<msg::DiagnosticArray> diagnostics_;
  Time due_{};
};

}  // namespace galilean::monitor
