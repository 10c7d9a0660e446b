// SPDX-License-Identifier: BSD-3-Clause
#include "sim/control/truth.h"

#include "sim/control/parts.h"

namespace galilean::sim {
namespace {

std::string holder_of(const World& world, BodyTag tag) {
  for (std::size_t i = 0; i < world.robot_count(); ++i)
    if (world.robot(i).gripper().held() == tag) return robot_name(i);
  return {};
}

msg::SimulationBody body_message(const World& world, const b2Body& body, const char* kind) {
  const BodyTag tag = tag_of(body);
  const Pose2 pose = pose_of(body);
  return {world.name_of(tag),           kind,
          pose.position_m.x(),          pose.position_m.y(),
          wrap_angle(pose.heading_rad), holder_of(world, tag)};
}

}  // namespace

msg::SimulationState truth_of(const World& world, const Pace& pace) {
  msg::SimulationState state;
  state.scenario = world.scenario().name;
  state.paused = pace.paused();
  state.rate = pace.rate();
  state.contest = to_string(world.referee().phase());
  state.width_m = world.scenario().arena.width_m;
  state.depth_m = world.scenario().arena.depth_m;
  for (std::size_t i = 0; i < world.robot_count(); ++i) {
    state.bodies.push_back(body_message(world, world.robot(i).body(), "robot"));
    for (const auto& [part, fault] : faults_of(world.robot(i).broken()))
      state.faults.push_back({robot_name(i), part, fault});
  }
  for (const auto& piece : world.objects().pieces())
    if (piece.body) state.bodies.push_back(body_message(world, *piece.body, to_string(piece.kind)));
  for (const b2Body* basket : world.objects().baskets())
    state.bodies.push_back(body_message(world, *basket, "basket"));
  for (const b2Body* chair : world.objects().chairs())
    state.bodies.push_back(body_message(world, *chair, "chair"));
  return state;
}

}  // namespace galilean::sim
