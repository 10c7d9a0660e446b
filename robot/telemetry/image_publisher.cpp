// SPDX-License-Identifier: BSD-3-Clause
#include "robot/telemetry/image_publisher.h"

#include <array>
#include <utility>

#include "core/wire/topic_names.h"
#include "core/wire/writer.h"
#include "robot/telemetry/image_encoding.h"

namespace galilean::robot {
namespace {

constexpr Duration kPicturePause = std::chrono::milliseconds(10);
constexpr int kLooksPerReaderCheck = 20;

}  // namespace

ImagePublisher::ImagePublisher(const TelemetrySource& source, ImageTap& tap, Worker::Report report)
    : tap_(tap), wall_(source.clock), frame_id_(source.robot + "/camera") {
  for (ImageChannel channel = 0; channel < tap.channels().size(); ++channel) {
    const std::string leaf = tap.channels()[channel] + "/compressed";
    outputs_.push_back({channel, wire::Writer<msg::CompressedImage>(
                                     source.participant, wire::robot_topic(source.robot, leaf))});
  }
  worker_ = Worker(
      [this](const std::stop_token& stop) {
        look();
        sleep_for(kPicturePause, stop);
      },
      std::move(report));
}

void ImagePublisher::look() {
  if (looks_++ % kLooksPerReaderCheck == 0) note_readers();
  for (Output& output : outputs_)
    if (tap_.take(output.channel)) show(output);
}

void ImagePublisher::note_readers() {
  wall_.refresh();
  for (const Output& output : outputs_) tap_.want(output.channel, output.writer.readers() > 0);
}

void ImagePublisher::show(Output& output) {
  const Picture& picture = tap_.newest(output.channel);
  const bool camera = output.channel == kCameraChannel;
  message_.header.stamp = wall_.stamp(picture.captured);
  message_.header.frame_id = frame_id_;
  message_.format = camera ? "jpeg" : "png";
  (camera ? encode_jpeg : encode_png)(picture.pixels, message_.data);
  // A lost picture does not matter, because images are best effort and the next one follows.
  static_cast<void>(output.writer.write(message_));
}

}  // namespace galilean::robot
