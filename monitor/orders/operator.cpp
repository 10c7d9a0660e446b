// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/orders/operator.h"

#include <unistd.h>

#include "core/account.h"
#include "core/wire/ros_time.h"

namespace galilean::monitor {
namespace {

constexpr int kFrontBumper = 0;

std::uint8_t kind_of(Operator::Word word) {
  namespace kinds = msg::Command_Constants;
  switch (word) {
    case Operator::Word::kHold:
      return kinds::HOLD;
    case Operator::Word::kResume:
      return kinds::RESUME;
    case Operator::Word::kStep:
      return kinds::STEP;
    case Operator::Word::kDecommission:
      return kinds::DECOMMISSION;
    case Operator::Word::kCommission:
      return kinds::COMMISSION;
    case Operator::Word::kStart:
      break;
  }
  return kinds::PUSH_BUMPER;
}

}  // namespace

bool Operator::say(Word word, const std::vector<std::string>& robots) {
  const std::int64_t now_ns = wire::wall_clock_ns();
  msg::Command command;
  command.stamp = wire::ros_time(now_ns);
  command.id = last_id_ =
      std::to_string(getpid()) + "-" + std::to_string(now_ns) + "-" + std::to_string(++said_);
  command.author = user_name();
  command.targets = robots;
  command.kind = kind_of(word);
  command.argument = kFrontBumper;
  return writer_.write(command);
}

std::string words_of(Operator::Word word) {
  switch (word) {
    case Operator::Word::kHold:
      return "hold";
    case Operator::Word::kResume:
      return "resume";
    case Operator::Word::kStep:
      return "step";
    case Operator::Word::kDecommission:
      return "decommission";
    case Operator::Word::kCommission:
      return "commission";
    case Operator::Word::kStart:
      break;
  }
  return "start";
}

}  // namespace galilean::monitor
