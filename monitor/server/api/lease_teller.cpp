// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/api/lease_teller.h"

#include <iostream>
#include <utility>

#include "core/wire/ros_time.h"
#include "core/wire/topic_names.h"
#include "monitor/pushes/history/push_messages.h"

namespace galilean::monitor {
namespace {

msg::LeaseChange message_of(const LeaseChange& change, Time now) {
  msg::LeaseChange message;
  message.stamp = wire::ros_time(wire::wall_clock_ns() - (now - change.at).count());
  message.id = new_id();
  message.robot = change.robot;
  message.kind = name_of(change.kind);
  message.author = change.by.name;
  message.other = change.other.name;
  message.reason = change.reason;
  message.text = in_words(change);
  message.holder = change.holder;
  message.asker = change.asker;
  return message;
}

void say_untold(const std::string& text, const std::string& why) {
  std::clog << "galilean-monitor: this change of a lease was not sent on DDS, because " << why
            << ": " << text << std::endl;
}

}  // namespace

LeaseTeller::LeaseTeller(LeaseDesk& desk, Worker& worker, wire::Participant& participant)
    : desk_(desk), worker_(worker), changes_(participant, wire::kLeaseChangeTopic) {}

void LeaseTeller::tell() {
  desk_.refresh();
  for (const auto& change : desk_.take_changes()) {
    std::clog << "galilean-monitor: lease of " << change.robot << ": " << in_words(change)
              << std::endl;
    auto message = message_of(change, desk_.now());
    send(message);
    if (message.holder.empty())
      newest_.erase(change.robot);
    else
      newest_[change.robot] = {std::move(message), sent_};
  }
  tell_again();
}

void LeaseTeller::tell_again() {
  if (newest_.size() > kTellAgainAfter) return;
  for (auto& [robot, newest] : newest_) {
    // Of a robot that the monitor has forgotten nobody is told.
    if (sent_ - newest.sent < kTellAgainAfter || !desk_.find(robot)) continue;
    send(newest.message);
    newest.sent = sent_;
  }
}

void LeaseTeller::send(const msg::LeaseChange& message) {
  ++sent_;
  const auto text = message.robot + ": " + message.text;
  worker_.run([this, message] { return changes_.write(message); },
              [text](bool is_taken) {
                if (!is_taken) say_untold(text, "DDS did not accept it");
              },
              [text](const std::string& why) { say_untold(text, why); });
}

}  // namespace galilean::monitor
