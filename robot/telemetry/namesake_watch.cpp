// SPDX-License-Identifier: BSD-3-Clause
#include "robot/telemetry/namesake_watch.h"

#include <algorithm>
#include <thread>

#include "core/wire/messages.h"
#include "core/wire/topic_names.h"

namespace galilean::robot {
namespace {

constexpr Duration kLookAgain = std::chrono::milliseconds(10);
/// The robot that is heard looks ten times a second for others of its name, and tells its operator.
constexpr Duration kToBeSeen = std::chrono::milliseconds(500);
/// More than two robots tell between two looks.
constexpr int kStatesKept = 64;

}  // namespace

NamesakeWatch::NamesakeWatch(wire::Participant& participant, const std::string& robot)
    : participant_(participant),
      robot_(robot),
      states_(participant, wire::robot_topic(robot, "state"), msg::RobotState::kRosType,
              kStatesKept) {}

int NamesakeWatch::count(Time now) {
  // A robot of another release may tell what is out of bounds here, and obeys nevertheless.
  states_.take_unchecked([&](const wire::Received& received) {
    const auto known = writers_.find(received.writer);
    if (known != writers_.end()) {
      known->second.heard = now;
    } else if (const auto sender = states_.sender(received.writer)) {
      writers_[received.writer] = {sender->name == wire::kReplayName, now};
    }
  });
  std::erase_if(writers_,
                [&](const auto& writer) { return now - writer.second.heard > kHeardFor; });
  return static_cast<int>(
      std::ranges::count_if(writers_, [](const auto& writer) { return !writer.second.is_replay; }));
}

Result<void> NamesakeWatch::expect_none(const Clock& clock, const std::function<bool()>& is_over) {
  Time end = clock.now() + kAcquaintance;
  bool is_heard = false;
  for (Time now = clock.now(); now < end && !is_over(); now = clock.now()) {
    if (!is_heard && count(now) > 0) {
      is_heard = true;
      end = std::max(end, now + kToBeSeen);
    }
    std::this_thread::sleep_for(kLookAgain);
  }
  if (!is_heard) return {};
  return Error{"a robot named " + robot_ + " lives in DDS domain " +
               std::to_string(participant_.domain()) +
               " already, and two robots of one name obey and tell as one; end that one, or "
               "start this one with another --name or --domain"};
}

}  // namespace galilean::robot
