// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>

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
  /// DDS keeps 64 changes for who joins later. The newest one of a robot that is held is told again
  /// after so many others, so that it is among them. Where more robots are held, it may not be.
  static constexpr std::uint64_t kTellAgainAfter = 32;

  struct Newest {
    msg::LeaseChange message;
    std::uint64_t sent = 0;  ///< its number among all that were sent, when it was sent last
  };

  void tell_again();
  void send(const msg::LeaseChange& message);

  LeaseDesk& desk_;
  Worker& worker_;
  wire::Writer<msg::LeaseChange> changes_;
  std::map<std::string, Newest> newest_;  ///< by the robots that are held
  std::uint64_t sent_ = 0;
};

}  // namespace galilean::monitor
