// SPDX-License-Identifier: BSD-3-Clause
#include "robot/telemetry/team_stop.h"

#include <string_view>

#include "robot/telemetry/wall_time.h"

namespace galilean::robot {
namespace {

constexpr std::string_view kMark = "break:";
constexpr std::string_view kSetBy = ", set by ";

}  // namespace

msg::Command command_of(const TeamStop& stop, std::uint64_t transition) {
  msg::Command command;
  command.stamp = WallTime::now();
  command.id = std::string(kMark) + stop.robot + ':' + std::to_string(transition);
  command.author = stop.robot + ": " + stop.break_point + std::string(kSetBy) + stop.author;
  command.kind = msg::Command_Constants::HOLD;
  return command;
}

std::optional<TeamStop> team_stop_in(const msg::Command& command) {
  if (command.kind != msg::Command_Constants::HOLD || !command.id.starts_with(kMark))
    return std::nullopt;
  const std::string rest = command.id.substr(kMark.size());
  TeamStop stop{.robot = rest.substr(0, rest.find(':')), .break_point = command.author};
  const std::string begin = stop.robot + ": ";
  if (stop.break_point.starts_with(begin)) stop.break_point.erase(0, begin.size());
  const auto end = stop.break_point.rfind(kSetBy);
  if (end == std::string::npos) return stop;
  stop.author = stop.break_point.substr(end + kSetBy.size());
  stop.break_point.resize(end);
  return stop;
}

}  // namespace galilean::robot
