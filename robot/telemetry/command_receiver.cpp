// SPDX-License-Identifier: BSD-3-Clause
#include "robot/telemetry/command_receiver.h"

#include <utility>

#include "core/device/comm_port.h"
#include "core/wire/topic_names.h"
#include "robot/log/log.h"
#include "robot/telemetry/order_words.h"

namespace galilean::robot {

CommandReceiver::CommandReceiver(const TelemetrySource& source, BreakDesk& desk, OrderGate& gate,
                                 const Worker::Report& report)
    : executive_(source.executive),
      desk_(desk),
      gate_(gate),
      place_(order_place(source.participant.domain(), wire::kCommandTopic)),
      commands_(
          source.participant, wire::kCommandTopic, source.robot,
          [this](const msg::Command& command, OrderGate::Origin origin) {
            return admit(command, std::move(origin));
          },
          [this](const msg::Command& command) { obey(command); }, report) {}

bool CommandReceiver::admit(const msg::Command& command, OrderGate::Origin origin) {
  if (!can_move(command)) return true;
  const auto admitted = gate_.admit(command, place_, what_is(command), std::move(origin));
  if (!admitted) desk_.refuse(command.id, admitted.error());
  return admitted.ok();
}

void CommandReceiver::push_bumper(const msg::Command& command) {
  const std::string which = std::to_string(command.argument);
  if (command.argument < 0 || command.argument >= ControllerStatus::kBumpers)
    return log_warning(command.author + " pushed bumper " + which +
                       ", which is not there: from 0 to " +
                       std::to_string(ControllerStatus::kBumpers - 1) + " are");
  log_info(command.author + " pushed bumper " + which);
  executive_.push_bumper(command.argument);
}

void CommandReceiver::obey(const msg::Command& command) {
  switch (command.kind) {
    case msg::Command_Constants::HOLD:
      return desk_.hold(command);
    case msg::Command_Constants::RESUME:
      return desk_.resume(command);
    case msg::Command_Constants::STEP:
      return desk_.step(command);
    case msg::Command_Constants::DECOMMISSION:
      log_info(command.author + " took this robot out of service");
      return executive_.decommission();
    case msg::Command_Constants::COMMISSION:
      log_info(command.author + " put this robot into service");
      return executive_.commission();
    case msg::Command_Constants::PUSH_BUMPER:
      return push_bumper(command);
    default:
      log_warning(command.author + " sent a command of unknown kind " +
                  std::to_string(command.kind));
  }
}

}  // namespace galilean::robot
