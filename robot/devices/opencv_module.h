// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "robot/devices/frame_source.h"

namespace galilean::robot {

inline constexpr auto kOpencvModuleFile = "libgalilean_opencv_source.so";
inline constexpr auto kMakeOpencvSource = "galilean_make_opencv_source";

/// The function that the module exports. It makes a source that the caller owns. The device is
/// opened by the first `grab`.
using MakeOpencvSource = FrameSource* (*)(const char* device);

}  // namespace galilean::robot
