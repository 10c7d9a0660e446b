// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bhdl/program/program.h"
#include "robot/devices/byte_pipe.h"
#include "robot/devices/frame_grabber.h"
#include "robot/devices/microcontroller_link.h"
#include "robot/devices/motor_drive.h"
#include "robot/executive/executive.h"
#include "sim/devices/simulated_board.h"
#include "sim/devices/simulated_camera.h"
#include "sim/headless/stuck_watch.h"
#include "sim/world/world.h"

namespace galilean::sim {

/// Measurements of one robot in a contest.
struct RobotStatistics {
  double distance_m = 0;  ///< true path
  double drift_m = 0;     ///< at the end, between the true and the believed place
  std::map<std::string, double> seconds_in_state;
  StuckWatch stuck;
};

/// One whole robot inside the simulator's process: the real executive, link, firmware and vision.
/// The world is behind the devices' interfaces. All of it runs in one thread, by the stepped clock.
class HeadlessRobot final : private robot::DeviceTuner {
 public:
  struct Setup {
    World& world;
    std::size_t index;
    const Scene& scene;
    Renderer& renderer;
    const Registry& components;
    const Clock& clock;
    const Clock& stopwatch;
    std::uint64_t seed;
    robot::TickObserver* observer = nullptr;  ///< sees every tick; may be null
  };
  explicit HeadlessRobot(const Setup& setup);
  HeadlessRobot(const HeadlessRobot&) = delete;
  HeadlessRobot& operator=(const HeadlessRobot&) = delete;

  Result<robot::ProgramId> load(bhdl::Program program);

  /// Runs the link and the board. It is called once in every step of the world.
  void run_board(Time now);
  void take_picture(Time now);
  void tick();
  void note(double dt_s);
  /// Lets the program continue from `situation`. Requires: no tick is under way.
  void restore(const robot::Situation& situation) { executive_.restore(situation); }

  [[nodiscard]] bool connected() const noexcept { return link_.healthy(); }
  [[nodiscard]] std::vector<std::string> problems() const;
  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  [[nodiscard]] const robot::Executive& executive() const noexcept { return executive_; }
  [[nodiscard]] const RobotBody& body() const noexcept { return body_; }
  /// Returns the pose by dead reckoning in the arena's frame, computed from the robot's true start.
  [[nodiscard]] Pose2 believed_pose() const;
  [[nodiscard]] RobotStatistics statistics() const;

 private:
  void tune(const robot::DeviceSettings& settings) noexcept override;
  [[nodiscard]] bool tries_to_move() const;

  std::string name_;
  RobotBody& body_;
  Pose2 start_;
  const Catalog& catalog_;
  std::optional<Pose2> first_belief_;
  robot::BytePipe line_;
  bool line_connected_ = true;
  SimulatedBoard board_;
  SimulatedCamera camera_;
  robot::MicrocontrollerLink link_;
  robot::WheelDrive drive_;
  robot::CameraGrabber grabber_;
  robot::Executive executive_;

  bool uses_camera_ = false;
  std::map<std::string, bool, std::less<>> state_drives_;
  std::map<std::string, double, std::less<>> seconds_in_state_;
  Vec2 last_position_m_;
  double distance_m_ = 0;
  StuckWatch stuck_;
};

}  // namespace galilean::sim
