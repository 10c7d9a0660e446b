// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "core/result.h"
#include "robot/devices/frame_source.h"

namespace galilean::robot {

/// Makes the source that a frame_grabber's `device` names. "ring:/name" is the simulator's camera.
/// Any other text is the device of a camera or a file. A missing camera is no error here, because
/// the source tries again to open it. Errors: OpenCV's module is missing or cannot be loaded.
[[nodiscard]] Result<std::unique_ptr<FrameSource>> make_frame_source(const std::string& device);

}  // namespace galilean::robot
