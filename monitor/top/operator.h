// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/wire/messages.h"
#include "core/wire/participant.h"
#include "core/wire/topic_names.h"
#include "core/wire/writer.h"

namespace galilean::monitor {

/// Sends an operator's commands to robots.
class Operator {
 public:
  enum class Word { kHold, kResume, kStart, kDecommission, kCommission };

  explicit Operator(wire::Participant& participant) : writer_(participant, wire::kCommandTopic) {}

  /// Returns the number of readers of the command topic, which is the number of robots that listen.
  [[nodiscard]] int listeners() const { return writer_.readers(); }
  /// Sends a command to the robots of these names, or to all if `robots` is empty. kStart pushes
  /// the front bumper. Returns false if DDS did not accept the command.
  [[nodiscard]] bool say(Word word, const std::vector<std::string>& robots);

 private:
  wire::Writer<msg::Command> writer_;
  unsigned long said_ = 0;
};

}  // namespace galilean::monitor
