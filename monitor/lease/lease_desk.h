// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/clock.h"
#include "core/result.h"
#include "monitor/lease/lease.h"

namespace galilean::monitor {

/// What an order does to robots.
enum class OrderKind {
  kStops,   ///< it makes them stand still, or keeps them so: everybody may give it at any time
  kSteers,  ///< it needs their leases
};

/// The leases of all robots, which every order to robots passes. An order that steers several
/// robots gets all of their leases, or none. For use by one thread.
class LeaseDesk {
 public:
  using Robots = std::vector<std::string>;

  /// Requires: `clock` outlives this.
  explicit LeaseDesk(const Clock& clock) : clock_(clock) {}

  /// Notes that `who` said something. It keeps what `who` holds from ending by silence.
  void hear(const OperatorId& who);
  /// Returns whether `who` may give an order to `robots`. If it steers, `who` gets those of their
  /// leases that are free.
  /// Errors: it steers, and others hold some of them. The sentence names who holds which, and says
  /// what to do. Nothing changed then.
  [[nodiscard]] Result<void> admit(OrderKind kind, const OperatorId& who, const Robots& robots);
  /// Asks for leases, answers who asks, takes leases over or ends them.
  /// Errors: one of the robots does not permit this. Nothing changed then.
  [[nodiscard]] Result<void> act(LeaseDeed deed, const OperatorId& who, const Robots& robots,
                                 const std::string& reason);
  /// Lets happen what time brings: silence, and questions that were not answered. Call it a few
  /// times a second, so that operators are told.
  void refresh();
  /// Ends the lease of a robot that the monitor forgets. Nobody is told, as there is nothing left
  /// to steer.
  void forget(const std::string& robot) { leases_.erase(robot); }
  /// Returns what changed since the last call, in its order.
  [[nodiscard]] std::vector<LeaseChange> take_changes();

  /// Returns the robot's lease, or null if nobody ever steered it.
  [[nodiscard]] const Lease* find(const std::string& robot) const;
  /// Returns the leases of robots that were steered once, by their names.
  [[nodiscard]] const std::map<std::string, Lease>& leases() const noexcept { return leases_; }
  /// Returns the robots that `who` holds or asks for.
  [[nodiscard]] Robots robots_of(const OperatorId& who) const;
  [[nodiscard]] Time now() const noexcept { return clock_.now(); }

 private:
  [[nodiscard]] Lease& lease_of(const std::string& robot);
  [[nodiscard]] Result<void> check_steering(const OperatorId& who, const Robots& robots) const;

  const Clock& clock_;
  std::map<std::string, Lease> leases_;
  std::vector<LeaseChange> changes_;
};

}  // namespace galilean::monitor
