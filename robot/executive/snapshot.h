// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>

#include "core/latest.h"
#include "core/static_vector.h"
#include "robot/executive/spsc_ring.h"
#include "robot/executive/tick_observer.h"

namespace galilean::robot {

/// A copy of all that a tick shows at its end. Names are indices into the program's description.
struct Snapshot {
  static constexpr std::size_t kMostVariables = 256;
  static constexpr std::size_t kMostForces = 128;
  static constexpr std::size_t kMostSightings = 96;
  static constexpr std::size_t kMostFailures = 16;

  struct VariableSample {
    static constexpr std::size_t kMostValues = 6;
    bool valid = false;
    ObjectClass object = ObjectClass::kUnknown;
    double certainty = 0;    ///< at `now`
    double decay_per_s = 0;  ///< from then on
    Time updated{};
    std::array<double, kMostValues> values{};  ///< as msg::Variable says for its type
  };
  struct ForceSample {
    Vec2 force = Vec2::Zero();
    bool active = false;
  };
  struct SightingSample {
    std::size_t variable = 0;  ///< the locate, among all variables
    ObjectClass object = ObjectClass::kUnknown;
    Sighting sighting;
  };
  struct Failure {
    std::size_t schema = 0;
    ShortText reason;
  };

  ProgramId program = 0;  ///< 0: none runs, and all that belongs to a program is empty
  std::uint32_t state = 0;
  Time state_since{};
  Time now{};
  std::uint64_t tick = 0;
  Duration tick_period{};
  Duration tick_time{};
  Duration longest_tick_time{};  ///< since `SnapshotTap::restart_longest`
  std::uint32_t overruns = 0;
  std::uint64_t transitions = 0;
  Standstill standstill;
  FaultReport fault;  ///< for which the robot is held; its cause is kNone if for none
  bool out_of_service = false;
  bool in_probation = false;
  bool uses_camera = false;
  DeviceHealth health;
  Pose2 pose;
  double speed_mps = 0;
  double turn_rate_radps = 0;
  StaticVector<VariableSample, kMostVariables> variables;  ///< in the order of the description
  StaticVector<ForceSample, kMostForces> forces;           ///< in the order of the description
  StaticVector<Failure, kMostFailures> failures;
  std::uint64_t frame = 0;  ///< the newest picture's number; 0: none yet
  Time frame_captured{};
  double view_angle_rad = 0;
  StaticVector<SightingSample, kMostSightings> sightings;  ///< of that picture
};

/// Hands the newest snapshot and every event from the control loop to the one thread that publishes
/// them. Neither thread waits.
class SnapshotTap final : public TickObserver {
 public:
  void on_event(const Event& event) noexcept override;
  void on_tick(const TickView& view) noexcept override;

  /// Reader. Take all events first and then the snapshot, so that the snapshot is not older than
  /// they are.
  std::optional<Event> next_event() noexcept { return events_.pop(); }
  /// Reader: takes the newest snapshot over. Returns false if there was no tick since the last
  /// call.
  bool take() noexcept { return snapshots_.take(); }
  [[nodiscard]] const Snapshot& newest() const noexcept { return snapshots_.reading(); }
  /// Reader: restarts the search for the longest tick.
  void restart_longest() noexcept { restart_longest_.store(true, std::memory_order_relaxed); }
  /// Returns how many events were lost because the reader did not take older ones in time.
  [[nodiscard]] std::uint32_t lost_events() const noexcept { return lost_events_.load(); }

 private:
  /// At most twenty events a second happen for long, and the network stalls for less than a second.
  static constexpr std::size_t kEventRoom = 256;
  static constexpr std::size_t kMostEventsOfATick = 32;

  void hand_over_events() noexcept;

  Latest<Snapshot> snapshots_;
  StaticVector<Event, kMostEventsOfATick> events_of_this_tick_;
  SpscRing<Event, kEventRoom> events_;
  Duration longest_tick_time_{};
  std::atomic<bool> restart_longest_{false};
  std::atomic<std::uint32_t> lost_events_{0};
};

}  // namespace galilean::robot
