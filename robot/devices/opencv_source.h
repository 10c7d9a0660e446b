// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "core/result.h"
#include "robot/devices/frame_source.h"

namespace galilean::robot {

/// Opens a camera, video or picture file through OpenCV. Its videoio brings in some hundred
/// megabytes of libraries, and so stands in a module that is loaded by the first call: a robot with
/// the simulator's camera never carries it. Fails if the module is not beside the executable.
[[nodiscard]] Result<std::unique_ptr<FrameSource>> open_opencv_source(const std::string& device);

}  // namespace galilean::robot
