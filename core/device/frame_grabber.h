// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/device/camera_geometry.h"
#include "core/device/device.h"
#include "core/device/frame.h"

namespace galilean {

/// The paper's frame_grabber.
class FrameGrabber : public Device {
 public:
  /// The newest frame as of `sense`, never null; its number is 0 before the first one.
  [[nodiscard]] virtual const Frame& frame() const noexcept = 0;
  [[nodiscard]] virtual const CameraGeometry& geometry() const noexcept = 0;
};

}  // namespace galilean
