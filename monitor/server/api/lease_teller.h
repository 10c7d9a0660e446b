// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/wire/messages.h"
#include "core/wire/participant.h"
#include "core/wire/writer.h"
#include "monitor/background/worker.h"
#include "monitor/lease/lease_desk.h"

namespace galilean::monitor {

/// Tells every change of a lease to all: on the wire, so that pages show it and recordings keep it,
/// and in the monitor's log. For use on the io_context's thread.
class LeaseTeller {
 public:
  /// Requires: all of them outlive this.
  LeaseTeller(LeaseDesk& desk, Worker& worker, wire::Participant& participant);

  /// Lets happen what time brings, and tells what changed since the last call.
  void tell();

 private:
  LeaseDesk& desk_;
  Worker& worker_;
  wire::Writer<msg::LeaseChange> changes_;
};

}  // namespace galilean::monitor
