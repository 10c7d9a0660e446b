// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/control/recorder_desk.h"

#include <algorithm>
#include <utility>

#include "core/wire/ros_time.h"
#include "monitor/record/recorder_topics.h"

namespace galilean::monitor {
namespace {

constexpr std::size_t kCommandIdsKept = 256;

}  // namespace

RecorderDesk::RecorderDesk(wire::Participant& participant, std::string name)
    : name_(std::move(name)),
      commands_(participant, kRecorderCommandTopic, msg::Command::kRosType),
      statuses_(participant, kRecorderStatusTopic) {}

std::vector<msg::Command> RecorderDesk::take() {
  std::vector<msg::Command> taken;
  commands_.take([&](const wire::Received& received) {
    msg::Command command;
    if (!msg::decode_cdr(received.cdr, command) || !is_meant(command)) return;
    if (!command.id.empty() && is_new(command.id)) taken.push_back(std::move(command));
  });
  return taken;
}

bool RecorderDesk::is_meant(const msg::Command& command) const {
  return command.targets.empty() ||
         std::ranges::find(command.targets, name_) != command.targets.end();
}

bool RecorderDesk::is_new(const std::string& id) {
  if (std::ranges::find(known_ids_, id) != known_ids_.end()) return false;
  known_ids_.push_back(id);
  if (known_ids_.size() > kCommandIdsKept) known_ids_.pop_front();
  return true;
}

void RecorderDesk::show(RecorderStatus status) {
  status.name = name_;
  // If DDS does not take it in time, it is told again in a second.
  static_cast<void>(statuses_.write(to_message(status, wire::wall_clock_ns())));
}

}  // namespace galilean::monitor
