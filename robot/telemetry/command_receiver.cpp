// SPDX-License-Identifier: BSD-3-Clause
#include "robot/telemetry/command_receiver.h"

#include <spdlog/spdlog.h>

#include "core/failure.h"
#include "core/wire/reader.h"
#include "core/wire/topic_names.h"
#include "robot/telemetry/targets.h"

namespace galilean::robot {

CommandReceiver::CommandReceiver(const TelemetrySource& source, const Worker::Report& report)
    : source_(source), reader_(source.participant, wire::kCommandTopic, msg::Command::kRosType) {
  // A thread of DDS calls it, from which an exception would end the process.
  const auto take_or_report = [this, report] {
    static_cast<void>(failure_of([&] { report(failure_of([&] { take(); })); }));
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
      spdlog::info("{} holds this robot", command.author);
      return source_.executive.hold();
    case msg::Command_Constants::RESUME:
      spdlog::info("{} lets this robot go on", command.author);
      return source_.executive.resume();
    case msg::Command_Constants::DECOMMISSION:
      spdlog::info("{} took this robot out of service", command.author);
      return source_.executive.decommission();
    case msg::Command_Constants::COMMISSION:
      spdlog::info("{} put this robot into service", command.author);
      return source_.executive.commission();
    case msg::Command_Constants::PUSH_BUMPER:
      spdlog::info("{} pushed bumper {}", command.author, command.argument);
      return source_.executive.push_bumper(command.argument);
    default:
      spdlog::warn("{} sent a command of unknown kind {}", command.author, command.kind);
  }
}

}  // namespace galilean::robot
