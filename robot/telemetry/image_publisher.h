// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/wire/writer.h"
#include "core/worker.h"
#include "robot/telemetry/image_tap.h"
#include "robot/telemetry/publisher.h"

namespace galilean::robot {

/// Publishes the camera's picture (JPEG) and the pictures that schemas make of it (PNG). Each is
/// published only while its topic has a reader.
class ImagePublisher {
 public:
  /// Errors: throws std::runtime_error if DDS refuses a topic.
  ImagePublisher(const TelemetrySource& source, ImageTap& tap, Worker::Report report);

 private:
  struct Output {
    ImageChannel channel;
    wire::Writer<msg::CompressedImage> writer;
  };

  void look();
  void note_readers();
  void show(Output& output);

  ImageTap& tap_;
  WallTime wall_;
  std::string frame_id_;
  std::vector<Output> outputs_;
  msg::CompressedImage message_;
  int looks_ = 0;
  Worker worker_;
};

}  // namespace galilean::robot
