// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/push_words.h"

#include <ctime>

#include "core/wire/messages.h"
#include "core/wire/ros_time.h"
#include "monitor/pushes/json.h"

namespace galilean::monitor {
namespace {

std::string short_hash(const std::string& hash) {
  return hash.substr(0, 8);
}

std::string clock_time(std::int64_t since_epoch_ns) {
  const std::time_t seconds = since_epoch_ns / 1'000'000'000;
  std::tm local{};
  localtime_r(&seconds, &local);
  char text[16];
  return std::string(text, std::strftime(text, sizeof text, "%H:%M:%S", &local));
}

std::string audience(const PushRecord& push) {
  if (push.targets.empty()) return "the team";
  std::string names;
  for (const auto& name : push.targets) names += (names.empty() ? "" : ", ") + name;
  return names;
}

}  // namespace

std::string program_words(const PushRecord& push) {
  return push.program + (push.hash.empty() ? "" : " (" + short_hash(push.hash) + ")");
}

Outcome conflict(const PushRecord& other) {
  return {409,
          {{"pushed", to_json(other)}},
          other.author + " is pushing " + program_words(other) + " to " + audience(other) +
              " since " + clock_time(other.pushed_ns) + "; wait for its end, or cancel it."};
}

Outcome overtaken(const std::string& replaces, const Stale& stale,
                  const std::optional<PushRecord>& by) {
  const std::string who = stale.robot.empty() ? "the team" : stale.robot;
  const std::string meant = "It is to replace " + short_hash(replaces) + ", but " + who + " runs ";
  if (!by)
    return {409,
            {{"running_hash", stale.hash}},
            meant + short_hash(stale.hash) +
                ", which was not pushed through this monitor; look at " +
                "it before you replace it."};
  return {409,
          {{"running_hash", stale.hash}, {"pushed", to_json(*by)}},
          meant + program_words(*by) + ", which " + by->author + " pushed at " +
              clock_time(by->pushed_ns) + "; look at it before you replace it."};
}

Outcome broken(const TargetCheck& check) {
  return {422,
          {{"robot", check.refused_by}, {"diagnostics", check.result.diagnostics}},
          "The program has errors; nothing was pushed."};
}

std::string too_late(const PushRecord& push) {
  if (push.progress.state == "running")
    return "Every robot has been sent " + program_words(push) +
           " already; push the program before it to go back.";
  return "This push is over: it is " + push.progress.state + ".";
}

msg::PushProgress progress_message(const PushRecord& push) {
  msg::PushProgress message;
  message.stamp = wire::ros_time(wire::wall_clock_ns());
  message.id = push.id;
  message.author = push.author;
  message.program = push.program;
  message.hash = push.hash;
  message.targets = push.targets;
  message.state = push.progress.state;
  for (const auto& step : push.progress.steps)
    message.steps.push_back({step.name, step.state, step.detail});
  return message;
}

}  // namespace galilean::monitor
