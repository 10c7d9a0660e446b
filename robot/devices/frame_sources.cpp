// SPDX-License-Identifier: BSD-3-Clause
#include "robot/devices/frame_sources.h"

#include <string_view>

#include "robot/devices/opencv_source.h"
#include "robot/devices/shared_frame_ring.h"

namespace galilean::robot {

Result<std::unique_ptr<FrameSource>> make_frame_source(const std::string& device) {
  constexpr std::string_view ring = "ring:";
  if (device.starts_with(ring))
    return std::unique_ptr<FrameSource>(new FrameRingReader(device.substr(ring.size())));
  return open_opencv_source(device);
}

}  // namespace galilean::robot
