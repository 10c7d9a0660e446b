// SPDX-License-Identifier: BSD-3-Clause
#include "sim/telemetry/score_publisher.h"

#include <chrono>

#include "core/wire/ros_time.h"
#include "core/wire/topic_names.h"

namespace galilean::sim {
namespace {

constexpr auto kPeriod = std::chrono::milliseconds(500);

msg::Score sheet_of(const World& world) {
  const Referee& referee = world.referee();
  msg::Score sheet;
  sheet.stamp = wire::ros_time(wire::wall_clock_ns());
  sheet.scenario = world.scenario().name;
  sheet.phase = to_string(referee.phase());
  sheet.elapsed_s = referee.elapsed_s();
  sheet.remaining_s = referee.remaining_s();
  sheet.pieces = static_cast<std::uint32_t>(world.objects().pieces().size());
  sheet.deposited = referee.deposited();
  sheet.collisions = referee.collisions();
  sheet.points = referee.score();
  for (std::size_t i = 0; i < referee.robots().size(); ++i)
    sheet.robots.push_back(
        {robot_name(i), referee.robots()[i].deposited, referee.robots()[i].collisions});
  sheet.points_per_piece = referee.rules().points_per_piece;
  sheet.points_per_collision = -referee.rules().penalty_per_collision;
  for (const RefereeCall& call : referee.calls())
    sheet.calls.push_back(
        {call.elapsed_s, robot_name(call.robot), to_string(call.what), call.points});
  return sheet;
}

bool differs(const msg::Score& a, const msg::Score& b) {
  return a.phase != b.phase || a.deposited != b.deposited || a.collisions != b.collisions;
}

}  // namespace

ScorePublisher::ScorePublisher(wire::Participant& participant)
    : writer_(participant, wire::kScoreTopic), thread_([this] { run(); }) {}

ScorePublisher::~ScorePublisher() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

void ScorePublisher::show(const World& world) {
  msg::Score sheet = sheet_of(world);
  const std::lock_guard lock(mutex_);
  fresh_ = fresh_ || differs(sheet, newest_);
  newest_ = std::move(sheet);
  if (fresh_) changed_.notify_one();
}

void ScorePublisher::run() {
  std::unique_lock lock(mutex_);
  while (!ending_) {
    changed_.wait_for(lock, kPeriod, [&] { return fresh_ || ending_; });
    fresh_ = false;
    if (newest_.scenario.empty()) continue;
    const msg::Score sheet = newest_;
    lock.unlock();
    // If Cyclone does not take a sheet in time, the next one follows within half a second.
    (void)writer_.write(sheet);
    lock.lock();
  }
}

}  // namespace galilean::sim
