// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "monitor/pushes/push.h"

namespace galilean::monitor {

inline constexpr const char* kPushId = "1";
inline constexpr const char* kRollbackId = "back";
inline constexpr const char* kNewHash = "new";

/// Returns an order to the team.
inline PushOrder order_for(const std::string& canary = {}, bool tries = false) {
  PushOrder order{.files = {{"main.bhdl", "text"}}, .targets = {}, .author = "balch"};
  order.trial.wanted = tries;
  order.canary = canary;
  return order;
}

inline OrderTargets targets_of(const std::vector<std::string>& awaited,
                               const std::vector<std::string>& silent = {}) {
  OrderTargets targets{.awaited = {}, .silent = silent};
  for (const auto& robot : awaited) targets.awaited.push_back({robot, {}});
  return targets;
}

inline Push ordered(PushOrder order, const std::vector<std::string>& silent = {}) {
  return {std::move(order),
          targets_of({"callisto", "ganymede", "io"}, silent),
          {.id = kPushId, .rollback_id = kRollbackId, .pushed_ns = 7}};
}

inline ProgramChecked checks() {
  return {CheckedProgram{.hash = kNewHash, .files = {{"main.bhdl", "text"}}, .replaces_hash = {}}};
}

inline ProgramChecked does_not_check() {
  return {TargetCheck{.result = {}, .refused_by = "io"}};
}

inline msg::ProgramReply said(const std::string& robot, ReplyStatus status,
                              const std::string& message = {}) {
  msg::ProgramReply reply;
  reply.id = kPushId;
  reply.robot = robot;
  reply.hash = kNewHash;
  reply.status = static_cast<std::uint8_t>(status);
  reply.message = message;
  return reply;
}

/// Returns what `request` asks for, such as "send io ganymede".
inline std::string in_words(const PushRequest& request) {
  struct {
    std::string operator()(const CheckProgram&) const { return "check"; }
    std::string operator()(const RecordPush&) const { return "record"; }
    std::string operator()(const TryProgram&) const { return "try"; }
    std::string operator()(const EndTrial&) const { return "end trial"; }
    std::string operator()(const SendProgram& send) const {
      if (send.push.targets.empty()) return "send to the team";
      std::string text = "send to";
      for (const auto& robot : send.push.targets) text += " " + robot;
      return text;
    }
    std::string operator()(const RollBack& back) const { return "roll back " + back.robot; }
    std::string operator()(const RecordReply& record) const {
      return "record reply of " + record.reply.robot;
    }
    std::string operator()(const TellProgress&) const { return "tell"; }
  } words;
  return std::visit(words, request);
}

/// Returns all requests of the push that were not taken yet, in their order.
inline std::vector<PushRequest> requests_of(Push& push) {
  std::vector<PushRequest> all;
  for (auto some = push.take_requests(); !some.empty(); some = push.take_requests())
    all.insert(all.end(), std::make_move_iterator(some.begin()),
               std::make_move_iterator(some.end()));
  return all;
}

inline std::vector<std::string> words_of(Push& push) {
  std::vector<std::string> words;
  for (const auto& request : requests_of(push)) words.push_back(in_words(request));
  return words;
}

}  // namespace galilean::monitor
