// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "core/result.h"
#include "robot/devices/frame_source.h"

namespace galilean::robot {

/// The source that a frame_grabber's device names: "ring:/name" is the simulator's camera, all else
/// a camera's device or a file. What is missing is looked for again and again, and is no error
/// here.
[[nodiscard]] Result<std::unique_ptr<FrameSource>> make_frame_source(const std::string& device);

}  // namespace galilean::robot
