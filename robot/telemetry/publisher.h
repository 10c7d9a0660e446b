// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>

#include "core/orders/order_memory.h"
#include "core/signing/trusted_keys.h"
#include "core/worker.h"
#include "robot/executive/executive.h"
#include "robot/executive/snapshot.h"
#include "robot/log/log_queue.h"
#include "robot/telemetry/accepted_senders.h"
#include "robot/telemetry/compose.h"
#include "robot/telemetry/thread_problems.h"

namespace galilean::robot {

struct RobotWriters;

/// The sources of what telemetry publishes. Requires: they outlive the objects that are made from
/// this.
struct TelemetrySource {
  std::string robot;
  wire::Participant& participant;
  Executive& executive;
  SnapshotTap& tap;
  Devices devices;
  const Catalog& catalog;
  const Clock& clock;
  AcceptedSenders accepted_senders{};
  /// Is called outside the control loop with each program that has proven itself in place of
  /// another, and whether a push brought it. It must not wait. May be null.
  std::function<void(const bhdl::Program& program, bool pushed)> keep = nullptr;
  std::optional<TrustedKeys> trust{};  ///< who may move the robot; none: anybody
  /// Who held the robot when its program died, and holds it still; empty: nobody.
  std::string held_by{};
  /// Is called outside the control loop when who holds the robot (empty: nobody, or a fault) or
  /// whether it is out of service has changed. It must not wait. May be null.
  std::function<void(const std::string& held_by, bool out_of_service)> keep_orders = nullptr;
  OrderMemory order_memory{};  ///< of those keys' orders
};

/// Publishes what the robot does. It uses a thread of its own, so that a stalled network delays
/// nothing else. Events are published as they come, with the state and variables that they led to.
/// State, variables, forces and pose follow ten times a second, sightings with each picture, and
/// diagnostics every second.
class Publisher {
 public:
  /// Its functions are called in the publisher's thread.
  struct Listener {
    std::function<void(const Event&)> event;  ///< with every event
    /// In every round with the newest snapshot, which is not older than the events before.
    std::function<void(const Snapshot&)> round;
  };

  /// Errors: throws std::runtime_error if DDS refuses a topic.
  Publisher(const TelemetrySource& source, LogQueue& log, const ThreadProblems& threads,
            Listener listener);

 private:
  void step();
  void tell(const Event& event);
  void tell_transition(const Event& event);
  void tell_program(ProgramId id);
  void log_rollback(const Event& event);
  void tell_sightings();
  void tell_regularly();
  void tell_state();
  void tell_what_is();
  void log_changes(const std::vector<Problem>& problems);
  [[nodiscard]] std::vector<Problem> problems() const;
  /// Returns null if the program's description is no longer kept.
  [[nodiscard]] const Description* describe(ProgramId id);

  TelemetrySource source_;
  LogQueue& log_;
  const ThreadProblems& threads_;
  Listener listener_;
  Composer compose_;
  std::shared_ptr<RobotWriters> writers_;
  std::shared_ptr<const Description> described_;
  std::vector<Problem> problems_;
  Time next_report_{};
  Time next_diagnosis_{};
  std::uint64_t last_frame_ = 0;
  Worker worker_;
};

}  // namespace galilean::robot
