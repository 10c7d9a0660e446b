#pragma once

#include <mutex>

#include "core/wire/reader.h"
#include "robot/telemetry/publisher.h"

namespace galilean::robot {

/// Does what operators say: hold, resume, push a bumper, commission and decommission. Commands act
/// from the next tick on.
class CommandReceiver {
 public:
  /// Throws std::runtime_error if DDS refuses the topic.
  explicit CommandReceiver(const TelemetrySource& source);

 private:
  void obey(const msg::Command& command);

  TelemetrySource source_;
  std::mutex taking_;
  wire::Reader reader_;
};

}  // namespace galilean::robot
