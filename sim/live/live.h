// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "sim/control/contest_start.h"
#include "sim/control/instructor.h"
#include "sim/control/pace.h"
#include "sim/live/faults.h"
#include "sim/live/live_robot.h"
#include "sim/live/run_folder.h"
#include "sim/telemetry/order_desk.h"
#include "sim/telemetry/score_publisher.h"

namespace galilean::sim {

struct LiveOptions {
  std::size_t robots = 3;
  std::uint64_t seed = 1;
  std::string run = "demo";           ///< part of every name, so that two simulators can run
  std::optional<double> autostart_s;  ///< push this long after the last robot connected; none:
                                      ///< never
  int domain = -1;                    ///< DDS; -1: as ROS_DOMAIN_ID says
  std::vector<DeviceFault> faults;
  std::filesystem::path boards;  ///< folder of the boards' boot counts; empty: they are not kept
};

/// The world in real time, for robots in processes of their own. Robots may end and come back:
/// their lines and cameras stay. The referee starts the contest by pushing a bumper of each robot.
/// If an operator started them before, the contest's clock begins when the first one moves, unless
/// an instructor had a word in the contest before. Between two steps it carries out the orders that
/// instructors send over DDS. While it is paused, the boards and the cameras are silent.
class LiveContest {
 public:
  [[nodiscard]] static Result<std::unique_ptr<LiveContest>> make(const Scenario& scenario,
                                                                 const LiveOptions& options);

  /// Returns one line of JSON that says where robots find their devices.
  [[nodiscard]] std::string ready_line() const;
  /// Runs until `ending`. Problems are printed once a second on stderr, and tried again.
  void run(const std::atomic<bool>& ending);
  /// Returns the referee's sheet as one line of JSON.
  [[nodiscard]] std::string score_line() const;

 private:
  LiveContest(const Scenario& scenario, std::unique_ptr<World> world, RunFolder folder,
              std::unique_ptr<wire::Participant> participant, const LiveOptions& options);
  void obey_orders();
  void carry_out(const msg::SimulationOrder& order);
  void step();
  void stand_still();
  void apply_faults();
  void start_when_ready();
  void publish();
  [[nodiscard]] bool anybody_moves() const;
  void take_pictures();
  [[nodiscard]] double now_s() const noexcept;

  LiveOptions options_;
  std::unique_ptr<World> world_;
  RunFolder folder_;
  std::unique_ptr<wire::Participant> participant_;
  // Ends after the score's publisher: while that one's writer lingers, its own messages are
  // confirmed too.
  OrderDesk desk_;
  ScorePublisher score_;
  Pace pace_;
  ContestStart start_;
  Instructor instructor_;
  bool starts_by_itself_ = true;  ///< until an instructor starts, pauses or resets the contest
  std::chrono::steady_clock::time_point published_{};
  Scene scene_;
  Renderer renderer_;
  std::vector<std::unique_ptr<LiveRobot>> robots_;
  std::uint64_t step_ = 0;
  std::uint64_t picture_steps_;
  std::optional<std::uint64_t> connected_step_;  ///< in which the last robot was first heard
};

}  // namespace galilean::sim
