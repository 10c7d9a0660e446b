// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "core/result.h"
#include "robot/devices/frame_source.h"

namespace galilean::robot {

/// Opens a camera, video or picture file through OpenCV. OpenCV's videoio needs about a hundred
/// megabytes of libraries. It is therefore in a module that the first call loads, so that a robot
/// with the simulator's camera does not need it. Errors: the module is not beside the executable,
/// or cannot be loaded.
[[nodiscard]] Result<std::unique_ptr<FrameSource>> open_opencv_source(const std::string& device);

}  // namespace galilean::robot
