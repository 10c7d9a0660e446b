// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "monitor/map/team_map.h"
#include "robot/executive/snapshot.h"
#include "robot/telemetry/compose.h"
#include "sim/headless/headless.h"

namespace galilean::monitor {

/// A headless contest whose robots' telemetry goes straight into a TeamMap. The map gets what the
/// network would carry, at the network's rates, on the stepped clock. It can therefore be compared
/// with the world's truth.
class MappedContest {
 public:
  enum class Starts {
    kMeasured,  ///< the map gets the places where the robots truly stand
    kRough,     ///< the map gets the scenario's places, before the jitter
  };
  struct Options {
    std::uint64_t seed = 1;
    double duration_s = 180;
    Starts starts = Starts::kMeasured;
    std::string scenario = "office";  ///< a scenario that ships, or a file
    std::size_t robots = 3;
    std::size_t group_size = RobotGroups::kMaxRobots;
  };

  explicit MappedContest(const Options& options);

  /// Runs the contest to its end. `look` is called each simulated second, after the map was
  /// updated.
  void run(const std::function<void(const MappedContest&, const msg::ObjectMap&)>& look);

  [[nodiscard]] const sim::HeadlessContest& contest() const noexcept { return *contest_; }
  [[nodiscard]] const TeamMap& map() const noexcept { return map_; }
  [[nodiscard]] Time now() const noexcept { return now_; }
  /// Are called with what a robot sent, before the map gets it.
  std::vector<std::function<void(std::size_t robot, const msg::Sightings&)>> on_sightings;
  /// Are called after each step of the world, before the map gets what robots report of it.
  std::vector<std::function<void()>> on_step;

 private:
  static constexpr std::int64_t kEpoch_ns = 1'000'000'000'000;

  struct Telemetry {
    robot::SnapshotTap tap;
    std::optional<robot::Composer> compose;
    std::shared_ptr<const robot::Description> program;
    std::uint64_t last_frame = 0;
    Time next_report{};
  };

  void after_step(Time now);
  void report(std::size_t robot);
  void report_regularly(Telemetry& telemetry, const robot::Snapshot& snapshot);

  TeamMap map_;
  SteppedClock stopped_;  ///< it does not advance, because the map does not use the messages' own
                          ///< stamps
  Registry components_;
  std::vector<std::unique_ptr<Telemetry>> telemetry_;
  std::unique_ptr<sim::HeadlessContest> contest_;
  std::function<void(const MappedContest&, const msg::ObjectMap&)> look_;
  Time now_{};
  Time next_update_{};
  Time next_look_{};
};

}  // namespace galilean::monitor
