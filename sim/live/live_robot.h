// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robot/devices/shared_frame_ring.h"
#include "sim/camera/renderer.h"
#include "sim/devices/pty_line.h"
#include "sim/devices/simulated_board.h"
#include "sim/live/faults.h"

namespace galilean::sim {

/// The body, board and camera of a robot whose program runs in a process of its own. Its serial
/// line is a pseudo-terminal. Its camera is a ring in shared memory.
class LiveRobot {
 public:
  /// `folder` is where the serial line's link, `<robot>.serial`, is made. `ring` is the name of the
  /// shared memory. `memory` counts the board's starts.
  LiveRobot(World& world, std::size_t index, const std::string& folder, std::string ring,
            BootMemory memory);
  /// Plugs in both devices: the serial line and the camera.
  Result<void> plug_in();

  /// Unplugs the devices that are faulty at `now_s` or that are broken, and plugs in the others. A
  /// broken board has no power.
  /// Each call tries again to plug in a device that could not be plugged in before.
  Result<void> apply_faults(const std::vector<DeviceFault>& faults, double now_s);
  void run_board(std::uint32_t now_ms) { board_.update(now_ms); }
  void take_picture(const Scene& scene, Renderer& renderer);
  /// Throws away what the robot sent to its board. It is called while simulated time stands still,
  /// so that no old command reaches the motors when it goes on.
  void ignore_commands();

  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  [[nodiscard]] const std::string& serial_path() const noexcept { return line_.name(); }
  [[nodiscard]] const std::string& ring_name() const noexcept { return ring_name_; }
  /// Returns whether the board heard from a robot since power-up.
  [[nodiscard]] bool connected() const noexcept { return board_.heard(); }
  /// Returns what went wrong with the board's memory, or an empty text.
  [[nodiscard]] const std::string& problem() const noexcept { return board_.problem(); }

 private:
  Result<void> open_ring();

  std::string name_;
  std::size_t index_;
  const RobotBody& body_;
  std::string ring_name_;
  PtyLine line_;
  SimulatedBoard board_;
  std::unique_ptr<robot::FrameRingWriter> ring_;
  std::unique_ptr<Frame> frame_ = std::make_unique<Frame>();
};

}  // namespace galilean::sim
