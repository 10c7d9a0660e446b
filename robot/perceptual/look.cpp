// SPDX-License-Identifier: BSD-3-Clause
#include "robot/perceptual/look.h"

#include "core/device/device_names.h"
#include "core/device/devices.h"
#include "core/device/frame.h"
#include "core/device/frame_grabber.h"
#include "robot/vision/supercomponent.h"

namespace galilean::robot {
namespace {

std::uint8_t* plane(Variable<Image>* image) noexcept {
  return image ? image->value.pixels.data() : nullptr;
}

void stamp(Variable<Image>* image, const Frame& frame, const Tick& tick) noexcept {
  if (!image) return;
  image->value.frame = frame.number;
  image->value.captured = frame.captured;
  image->mark_written(1, tick.now, tick.number);
}

}  // namespace

void Look::describe(Declaration<Look>& is) {
  is.help("Splits a new camera picture into supercomponents and intensity.");
  is.writes(&Look::red_, "red_variable", "red less green and blue")
      .optional()
      .role(Role::kChannel, "superred");
  is.writes(&Look::green_, "green_variable", "green less red and blue")
      .optional()
      .role(Role::kChannel, "supergreen");
  is.writes(&Look::blue_, "blue_variable", "blue less red and green")
      .optional()
      .role(Role::kChannel, "superblue");
  is.writes(&Look::dark_, "dark_variable", "intensity, for blobs of polarity dark")
      .optional()
      .role(Role::kChannel, "dark");
  is.flag(&Look::normalise_, "normalise", true,
          "whether dim pictures are first scaled to full brightness");
  is.needs(kFrameGrabberName);
  is.uses_devices(&Look::devices_);
}

void Look::run(const Tick& tick) {
  const Frame& frame = devices_->frame_grabber.frame();
  if (frame.number == last_frame_) return;
  last_frame_ = frame.number;
  const Gain gain = normalise_ ? normalising_gain(frame.rgb, Frame::kWidth) : kUnityGain;
  split_components(frame.rgb, gain, {plane(red_), plane(green_), plane(blue_), plane(dark_)});
  for (auto* image : {red_, green_, blue_, dark_}) stamp(image, frame, tick);
}

}  // namespace galilean::robot
