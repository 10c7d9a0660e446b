#pragma once

#include <thread>
#include <vector>

#include "core/wire/writer.h"
#include "robot/telemetry/image_tap.h"
#include "robot/telemetry/publisher.h"

namespace galilean::robot {

/// Shows the camera (JPEG) and what schemas make of it (PNG), each only while somebody reads it.
class ImagePublisher {
 public:
  /// Throws std::runtime_error if DDS refuses a topic.
  ImagePublisher(const TelemetrySource& source, ImageTap& tap);

 private:
  struct Output {
    ImageChannel channel;
    wire::Writer<msg::CompressedImage> writer;
  };

  void run(const std::stop_token& stop);
  void note_readers();
  void show(Output& output);

  ImageTap& tap_;
  WallTime wall_;
  std::string frame_id_;
  std::vector<Output> outputs_;
  msg::CompressedImage message_;
  std::jthread thread_;
};

}  // namespace galilean::robot
