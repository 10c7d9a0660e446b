// SPDX-License-Identifier: BSD-3-Clause
#include "robot/telemetry/command_receiver.h"

#include "core/failure.h"
#include "core/wire/reader.h"
#include "core/wire/topic_names.h"
#include "robot/log/log.h"
#include "robot/telemetry/targets.h"

namespace galilean::robot {

CommandReceiver::CommandReceiver(const TelemetrySource& source, const Worker::Report& report)
    : source_(source), reader_(source.participant, wire::kCommandTopic, msg::Command::kRosType) {
  // A thread of DDS calls this function. An exception from it would end the process.
  const auto take_or_report = [this, report] {
    const auto taken = attempt([&] { take(); });
    static_cast<void>(attempt([&] { report(taken ? "" : taken.error().message); }));
  };
  reader_.on_data(take_or_report);
  take_or_report();
}

void CommandReceiver::take() {
  const std::lock_guard lock(taking_);
  reader_.take([this](const wire::Received& received) {
    msg::Command command;
    if (msg::decode_cdr(received.cdr, command)) obey(command);
  });
}

void CommandReceiver::obey(const msg::Command& command) {
  if (!is_meant(source_.robot, command.targets)) return;
  switch (command.kind) {
    case msg::Command_Constants::HOLD:
      log_info(command.author + " holds this robot");
      return source_.executive.hold();
    case msg::Command_Constants::RESUME:
      log_info(command.author + " lets this robot go on");
      return source_.executive.resume();
    case msg::Command_Constants::DECOMMISSION:
      log_info(command.author + " took this robot out of service");
      return source_.executive.decommission();
    case msg::Command_Constants::COMMISSION:
      log_info(command.author + " put this robot into service");
      return source_.executive.commission();
    case msg::Command_Constants::PUSH_BUMPER:
      log_info(command.author + " pushed bumper " + std::to_string(command.argument));
      return source_.executive.push_bumper(command.argument);
    default:
      log_warning(command.author + " sent a command of unknown kind " +
                  std::to_string(command.kind));
  }
}

}  // namespace galilean::robot
