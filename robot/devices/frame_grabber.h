// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <mutex>
#include <string>

#include "core/device/camera_geometry.h"
#include "core/device/frame.h"
#include "core/device/frame_grabber.h"
#include "core/latest.h"
#include "robot/devices/frame_grabber_settings.h"
#include "robot/devices/frame_source.h"

namespace galilean::robot {

/// The frame_grabber of a robot. One I/O thread calls `pump` and `fail`; the headless simulator
/// calls `pump` between ticks. The control loop calls the other methods and finds the newest whole
/// picture without waiting. Pictures are stored in three places that are made once.
class CameraGrabber final : public FrameGrabber {
 public:
  CameraGrabber(FrameSource& source, const FrameGrabberSettings& settings);

  /// I/O side: takes the next picture, if there is one.
  void pump(Time now);
  /// I/O side: reports that `pump` threw. The camera counts as missing until `pump` succeeds again.
  void fail(const std::string& why);

  /// Applies another program's settings, except for the device. Belongs to the control loop.
  void configure(const FrameGrabberSettings& settings) noexcept;

  void sense(Time now) noexcept override;
  [[nodiscard]] bool healthy() const noexcept override { return healthy_; }
  [[nodiscard]] std::string problem() const override;
  [[nodiscard]] const Frame& frame() const noexcept override { return frames_.reading(); }
  [[nodiscard]] const CameraGeometry& geometry() const noexcept override { return geometry_; }

 private:
  void note_problem(std::string problem);

  FrameSource& source_;
  Latest<Frame> frames_;
  std::uint64_t grabbed_ = 0;

  Duration timeout_{};
  CameraGeometry geometry_;
  bool healthy_ = false;
  std::atomic<bool> failed_{false};
  mutable std::mutex problem_mutex_;
  std::string problem_;
};

}  // namespace galilean::robot
