// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/orders/signed_writer.h"
#include "core/wire/messages.h"
#include "core/wire/participant.h"
#include "core/wire/topic_names.h"

namespace galilean::monitor {

/// Sends an operator's commands to robots.
class Operator {
 public:
  enum class Word { kHold, kResume, kStep, kStart, kDecommission, kCommission };

  /// `signer` signs the commands; null: nobody does.
  explicit Operator(wire::Participant& participant, std::shared_ptr<OrderSigner> signer = nullptr)
      : writer_(participant, wire::kCommandTopic, std::move(signer)) {}

  /// Returns the number of readers of the command topic, which is the number of robots that listen.
  [[nodiscard]] int listeners() const { return writer_.readers(); }
  /// Sends a command to the robots of these names, or to all if `robots` is empty. kStart pushes
  /// the front bumper. Returns false if DDS did not accept the command.
  [[nodiscard]] bool say(Word word, const std::vector<std::string>& robots);
  /// Returns the id of the last command, which comes back in the robots' answers to a step.
  [[nodiscard]] const std::string& last_id() const noexcept { return last_id_; }

 private:
  SignedWriter<msg::Command> writer_;
  unsigned long said_ = 0;
  std::string last_id_;
};

/// Returns the word as a command's name has it, such as "hold".
[[nodiscard]] std::string words_of(Operator::Word word);

}  // namespace galilean::monitor
