// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace galilean {

/// The robot's devices as programs, catalogs and reports call them.
inline constexpr const char* kCommPortName = "comm_port";
inline constexpr const char* kMotorDriveName = "motor_drive";
inline constexpr const char* kFrameGrabberName = "frame_grabber";
/// The gripper is wired to the comm_port. Programs do not declare it.
inline constexpr const char* kGripperName = "gripper";

}  // namespace galilean
