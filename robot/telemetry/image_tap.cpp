// SPDX-License-Identifier: BSD-3-Clause
#include "robot/telemetry/image_tap.h"

#include <algorithm>
#include <string_view>

#include "core/device/devices.h"
#include "core/device/frame.h"
#include "core/device/frame_grabber.h"

namespace galilean::robot {
namespace {

/// Somewhat less than a tenth of a second. A camera of ten pictures a second is never quite
/// regular, and all of its pictures should pass.
constexpr Duration kLeastApart = std::chrono::milliseconds(90);

const Variable<Image>* image_of(const RunningProgram& program, std::string_view channel) noexcept {
  for (const auto& label : program.description->images)
    if (label.channel == channel) return &program.variables.all<Image>()[label.index];
  return nullptr;
}

}  // namespace

ImageTap::Channel::Channel(std::size_t bytes)
    : pictures(Picture{.pixels = std::vector<std::uint8_t>(bytes)}) {}

void ImageTap::Channel::offer(std::span<const std::uint8_t> pixels, std::uint64_t frame,
                              Time captured) noexcept {
  const bool too_soon = last_frame != 0 && captured - last_captured < kLeastApart;
  if (frame == 0 || frame == last_frame || too_soon) return;
  last_frame = frame;
  last_captured = captured;
  Picture& picture = pictures.writing();
  picture.frame = frame;
  picture.captured = captured;
  std::ranges::copy(pixels, picture.pixels.begin());
  pictures.publish();
}

ImageTap::ImageTap(const Catalog& catalog) : names_(picture_channels(catalog)) {
  names_.insert(names_.begin() + kCameraChannel, "camera");
  for (std::size_t i = 0; i < names_.size(); ++i)
    channels_.emplace_back(i == kCameraChannel ? Frame::kBytes : Image::kWidth * Image::kHeight);
}

void ImageTap::on_tick(const TickView& view) noexcept {
  Channel& camera = channels_[kCameraChannel];
  const Frame& frame = view.devices.frame_grabber.frame();
  if (camera.wanted.load(std::memory_order_relaxed))
    camera.offer(frame.rgb, frame.number, frame.captured);
  if (!view.program) return;
  for (std::size_t i = 1; i < channels_.size(); ++i) {
    if (!channels_[i].wanted.load(std::memory_order_relaxed)) continue;
    if (const auto* image = image_of(*view.program, names_[i]))
      channels_[i].offer(image->value.pixels, image->value.frame, image->value.captured);
  }
}

void ImageTap::want(ImageChannel channel, bool wanted) noexcept {
  channels_[channel].wanted.store(wanted, std::memory_order_relaxed);
}

bool ImageTap::take(ImageChannel channel) noexcept {
  return channels_[channel].pictures.take();
}

const Picture& ImageTap::newest(ImageChannel channel) const noexcept {
  return channels_[channel].pictures.reading();
}

}  // namespace galilean::robot
