// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/wire/messages.h"
#include "core/wire/participant.h"
#include "core/wire/topic_names.h"
#include "core/wire/writer.h"

namespace galilean::monitor {

/// Sends an operator's word to robots.
class Operator {
 public:
  enum class Word { kHold, kResume, kStart };

  explicit Operator(wire::Participant& participant) : writer_(participant, wire::kCommandTopic) {}

  /// Robots that listen now.
  [[nodiscard]] int listeners() const { return writer_.readers(); }
  /// `robots`: their names; none: all. False if it could not be sent.
  [[nodiscard]] bool say(Word word, const std::vector<std::string>& robots);

 private:
  wire::Writer<msg::Command> writer_;
  unsigned long said_ = 0;
};

}  // namespace galilean::monitor
