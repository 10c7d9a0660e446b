// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "monitor/map/team_map.h"
#include "robot/executive/snapshot.h"
#include "robot/telemetry/compose.h"
#include "sim/headless/headless.h"

namespace galilean::monitor {

/// A headless contest whose robots' telemetry goes straight into a TeamMap. The telemetry is what
/// the network would carry, at the same rates, on the stepped clock. So the map can be compared
/// with the truth.
class MappedContest {
 public:
  enum class Starts {
    kMeasured,  ///< the map is given the true starting poses
    kRough,     ///< the map is given the scenario's starting poses, before the jitter
  };
  struct Options {
    std::uint64_t seed = 1;
    double duration_s = 180;
    Starts starts = Starts::kMeasured;
    std::string scenario = "office";  ///< the name of a scenario that ships, or a file
    std::size_t robots = 3;
    std::size_t group_size = RobotGroups::kMaxRobots;
  };

  explicit MappedContest(const Options& options);

  /// Runs the contest to its end. Calls `look` each simulated second, after an update of the map.
  void run(const std::function<void(const MappedContest&, const msg::ObjectMap&)>& look);

  [[nodiscard]] const sim::HeadlessContest& contest() const noexcept { return *contest_; }
  [[nodiscard]] const TeamMap& map() const noexcept { return map_; }
  [[nodiscard]] Time now() const noexcept { return now_; }
  /// Is called with the sightings that a robot sent, before the map gets them. It may be empty.
  std::function<void(std::size_t robot, const msg::Sightings&)> on_sightings;

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
  SteppedClock stopped_;  ///< for the messages' own stamps, which the map does not use
  Registry components_;
  std::vector<std::unique_ptr<Telemetry>> telemetry_;
  std::unique_ptr<sim::HeadlessContest> contest_;
  std::function<void(const MappedContest&, const msg::ObjectMap&)> look_;
  Time now_{};
  Time next_update_{};
  Time next_look_{};
};

}  // namespace galilean::monitor
