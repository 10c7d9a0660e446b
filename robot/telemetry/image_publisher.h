// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/wire/writer.h"
#include "core/worker.h"
#include "robot/telemetry/image_tap.h"
#include "robot/telemetry/publisher.h"

namespace galilean::robot {

/// Shows the camera (JPEG) and what schemas make of it (PNG), each only while somebody reads it.
class ImagePublisher {
 public:
  /// Throws std::runtime_error if DDS refuses a topic.
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
