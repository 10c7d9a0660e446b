// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/device/camera_geometry.h"
#include "core/device/device.h"
#include "core/device/frame.h"

namespace galilean {

/// The paper's frame_grabber: the camera.
class FrameGrabber : public Device {
 public:
  /// Returns the frame that the last `sense` took over. Its number is 0 before the first frame.
  [[nodiscard]] virtual const Frame& frame() const noexcept = 0;
  [[nodiscard]] virtual const CameraGeometry& geometry() const noexcept = 0;
};

}  // namespace galilean
