#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "core/clock.h"

namespace galilean {

/// What the microcontroller last said.
struct ControllerStatus {
  static constexpr int kBumpers = 8;

  Time received{};              ///< when it arrived here
  std::uint8_t bumpers = 0;     ///< bit i: switch i is pressed
  bool beam_broken = false;     ///< something stands between the gripper's hands
  bool gripper_closed = false;  ///< the servo has reached its closed stop
  double left_travel_m = 0;     ///< of the left wheel since the board started, forward positive
  double right_travel_m = 0;
  double left_speed_mps = 0;
  double right_speed_mps = 0;
  std::uint32_t epoch = 0;  ///< counts the board's restarts: travel began anew
};

/// Common to all devices. `sense` and what schemas call belong to the control loop: they neither
/// block nor allocate. Bytes and frames move in another thread, or between ticks.
class Device {
 public:
  virtual ~Device() = default;
  /// Start of a tick: takes over the newest that arrived.
  virtual void sense(Time now) noexcept = 0;
  /// False while it is missing or silent for longer than its timeout.
  [[nodiscard]] virtual bool healthy() const noexcept = 0;
  /// One sentence on what is missing and what to do; empty when well. Any thread but the control
  /// loop.
  [[nodiscard]] virtual std::string problem() const = 0;
};

enum class GripperCommand : std::uint8_t { kOpen, kClose };

/// The paper's comm_port: the serial line to the microcontroller.
class CommPort : public Device {
 public:
  /// As of `sense`. Stays the last known while the line is down (see `healthy`).
  [[nodiscard]] virtual const ControllerStatus& status() const noexcept = 0;
  virtual void command_gripper(GripperCommand command) noexcept = 0;
};

/// One movement. The wheels stop by themselves after the limits, or when commands cease.
struct DriveCommand {
  double speed_mps = 0;         ///< forward positive
  double turn_rate_radps = 0;   ///< counter-clockwise positive
  double distance_limit_m = 0;  ///< of the robot's centre; 0: none
  double angle_limit_rad = 0;   ///< 0: none
};

/// The paper's motor_drive: steering and translation.
class MotorDrive : public Device {
 public:
  virtual void drive(const DriveCommand& command) noexcept = 0;
  virtual void stop() noexcept = 0;
  /// Speeds that the program asks for: what a schema drives and turns with.
  [[nodiscard]] virtual double forward_speed_mps() const noexcept = 0;
  [[nodiscard]] virtual double turning_speed_radps() const noexcept = 0;
  /// Half the track: metres of wheel travel a radian of turning in place.
  [[nodiscard]] virtual double turn_radius_m() const noexcept = 0;
};

/// A horizontal pinhole camera over a flat floor. Focal lengths differ since NTSC pixels are not
/// square.
struct CameraGeometry {
  int width_px = 352;
  int height_px = 186;
  double view_angle_rad = 73.5 * 3.14159265358979323846 / 180;  ///< horizontal
  double height_m = 0.20;                                       ///< over the floor
  double forward_m = 0.10;                                      ///< in front of the robot's centre
};

/// A colour picture: 8-bit red, green, blue interleaved, row-major from the top left.
struct Frame {
  static constexpr int kWidth = 352;
  static constexpr int kHeight = 186;
  static constexpr int kBytes = kWidth * kHeight * 3;

  std::uint64_t number = 0;  ///< 1, 2, 3 …; 0: none yet
  Time captured{};
  std::array<std::uint8_t, kBytes> rgb{};
};

/// The paper's frame_grabber.
class FrameGrabber : public Device {
 public:
  /// The newest frame as of `sense`, never null; its number is 0 before the first one.
  [[nodiscard]] virtual const Frame& frame() const noexcept = 0;
  [[nodiscard]] virtual const CameraGeometry& geometry() const noexcept = 0;
};

/// What a robot has. Outlives every program that it runs.
struct Devices {
  CommPort& comm_port;
  MotorDrive& motor_drive;
  FrameGrabber& frame_grabber;
};

}  // namespace galilean
