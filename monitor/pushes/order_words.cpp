// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/order_words.h"

#include "core/wire/ros_time.h"
#include "monitor/pushes/history/replies.h"
#include "monitor/pushes/history/words.h"

namespace galilean::monitor {
namespace {

namespace kinds = msg::Command_Constants;

std::string word_of_command(std::uint8_t kind) {
  switch (kind) {
    case kinds::HOLD:
      return "hold";
    case kinds::RESUME:
      return "resume";
    case kinds::PUSH_BUMPER:
      return "push_bumper";
    case kinds::DECOMMISSION:
      return "decommission";
    case kinds::COMMISSION:
      return "commission";
    case kinds::STEP:
      return "step";
    default:
      return "command " + std::to_string(kind);
  }
}

std::string word_of_point(std::uint8_t kind) {
  namespace points = msg::BreakPoint_Constants;
  if (kind == points::STOP) return "stop";
  if (kind == points::STOP_TEAM) return "stop_team";
  return kind == points::LOCK ? "lock" : "";
}

template <class M>
OrderRecord record_named(const M& order, std::string kind) {
  return {.id = order.id,
          .ordered_ns = wire::since_epoch_ns(order.stamp),
          .author = order.author,
          .kind = std::move(kind),
          .targets = {},
          .detail = {},
          .outcomes = {}};
}

}  // namespace

OrderRecord record_of(const msg::Command& command) {
  auto record = record_named(command, word_of_command(command.kind));
  record.targets = command.targets;
  if (command.kind == kinds::PUSH_BUMPER)
    record.detail = "bumper " + std::to_string(command.argument);
  return record;
}

OrderRecord record_of(const msg::BreakOrder& order) {
  auto record = record_named(order, "breaks: " + order.order);
  record.targets = order.targets;
  for (const auto& point : order.points) {
    const auto word = word_of_point(point.kind);
    record.detail += (record.detail.empty() ? "" : "; ") + point.from_state + " -> " +
                     point.to_state + (word.empty() ? "" : " " + word);
  }
  return record;
}

OrderRecord record_of(const msg::ProgramRollback& order) {
  auto record = record_named(order, "roll back");
  record.targets = order.targets;
  record.detail = order.hash + ": " + order.reason;
  return record;
}

OrderRecord record_of(const msg::SimulationOrder& order) {
  auto record = record_named(order, "simulation: " + order.order);
  record.targets = {order.simulation};
  for (const auto& word : {order.subject, order.part, order.fault})
    if (!word.empty()) record.detail += (record.detail.empty() ? "" : " ") + word;
  return record;
}

std::string obedience(std::uint8_t kind, const msg::RobotState& before,
                      const msg::RobotState& now) {
  switch (kind) {
    case kinds::HOLD:
      return now.held ? "is held" : "";
    case kinds::RESUME:
      return now.held ? "" : "goes on";
    case kinds::DECOMMISSION:
      return now.out_of_service ? "is out of service" : "";
    case kinds::COMMISSION:
      return now.out_of_service ? "" : "is in service";
    case kinds::PUSH_BUMPER:
      return now.transitions > before.transitions ? "went to " + now.state : "";
    default:
      return {};
  }
}

std::string outcome_of(const msg::BreakAnswer& answer) {
  return answer.refused.empty() ? "did it" : "refused: " + answer.refused;
}

std::string outcome_of(const msg::ProgramReply& reply) {
  const auto word = to_text(reply_status(reply.status));
  return reply.message.empty() ? word : word + ": " + reply.message;
}

std::string outcome_of(const msg::SimulationEvent& event) {
  return event.done ? event.text : "refused: " + event.text;
}

}  // namespace galilean::monitor
