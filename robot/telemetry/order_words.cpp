// SPDX-License-Identifier: BSD-3-Clause
#include "robot/telemetry/order_words.h"

#include <algorithm>

#include "core/cut_text.h"
#include "core/orders/stopping_orders.h"
#include "core/visible_text.h"

namespace galilean::robot {
namespace {

constexpr std::size_t kLongestName = 64;
constexpr std::size_t kHashBytesShown = 8;

/// Returns a text that a stranger chose, as it can be shown in a sentence.
std::string shown(std::string_view text, std::size_t most_bytes = kLongestName) {
  return visible(cut_text(text, most_bytes));
}

}  // namespace

bool can_move(const msg::Command& command) noexcept {
  return !only_stops(command);
}

bool can_move(const msg::BreakOrder& order, const std::vector<BreakPoint>& points) {
  if (!only_stops(order)) return true;
  const auto is_there = [&](const msg::BreakPoint& wanted) {
    const StateChange place{wanted.from_state, wanted.to_state};
    return std::ranges::any_of(points,
                               [&](const BreakPoint& point) { return point.at.overlaps(place); });
  };
  return std::ranges::any_of(order.points, is_there);
}

std::string what_is(const msg::Command& command) {
  switch (command.kind) {
    case msg::Command_Constants::HOLD:
      return "A hold";
    case msg::Command_Constants::RESUME:
      return "A resume";
    case msg::Command_Constants::PUSH_BUMPER:
      return "A push of a bumper";
    case msg::Command_Constants::DECOMMISSION:
      return "A decommission";
    case msg::Command_Constants::COMMISSION:
      return "A commission";
    case msg::Command_Constants::STEP:
      return "A step";
    default:
      return "A command of unknown kind";
  }
}

std::string what_is(const msg::BreakOrder& order) {
  return "The order '" + shown(order.order) + "' about break points";
}

std::string what_is(const msg::ProgramPush& push) {
  return "A push of program " + shown(push.hash, kHashBytesShown);
}

std::string what_is(const msg::ProgramRollback& order) {
  return "A rollback of program " + shown(order.hash, kHashBytesShown);
}

std::string words_of(const std::optional<wire::Sender>& sender) {
  if (!sender) return "a participant that has already left";
  const std::string name = "'" + shown(sender->name) + "'";
  return sender->address.empty() ? name : name + " (" + shown(sender->address) + ")";
}

}  // namespace galilean::robot
