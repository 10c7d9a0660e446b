// SPDX-License-Identifier: BSD-3-Clause
#include "sim/headless/headless.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <ostream>

#include "core/json_text.h"

namespace galilean::sim {
namespace {

constexpr Duration kStep = std::chrono::milliseconds(10);
constexpr std::uint64_t kTickSteps = 5;
constexpr std::uint64_t kStepsASecond = 100;
constexpr std::uint64_t kMostWait = 10 * kStepsASecond;
constexpr std::uint64_t kPush = kStepsASecond / 2;
constexpr std::uint8_t kPushedSwitches = 1;  // the front switch

}  // namespace

Result<std::unique_ptr<HeadlessContest>> HeadlessContest::make(const Scenario& scenario,
                                                               const Registry& components,
                                                               const bhdl::Program& program,
                                                               const HeadlessOptions& options) {
  Scenario timed = options.start ? scenario_of(scenario, *options.start) : scenario;
  timed.rules.duration_s = options.duration_s;
  auto world = World::make(timed, options.robots, options.seed);
  if (!world) return world.error();
  std::unique_ptr<HeadlessContest> contest(
      new HeadlessContest(timed, components, std::move(world).value(), options));
  if (const auto loaded = contest->load(program); !loaded) return loaded.error();
  return contest;
}

HeadlessContest::HeadlessContest(const Scenario& scenario, const Registry& components,
                                 std::unique_ptr<World> world, const HeadlessOptions& options)
    : options_(options),
      world_(std::move(world)),
      contest_start_(*world_),
      instructor_(*world_, pace_, contest_start_),
      scene_(scene_of(scenario)),
      renderer_({}, scenario.camera, Random(options.seed).child("camera")),
      picture_steps_(static_cast<std::uint64_t>(
          std::lround(static_cast<double>(kStepsASecond) / scenario.camera.rate_hz))) {
  for (std::size_t i = 0; i < options.robots; ++i) {
    const std::uint64_t seed = Random(options.seed).child(robot_name(i)).child("executive").bits();
    HeadlessRobot::Setup setup{*world_, i, scene_, renderer_, components, clock_, stopwatch_, seed};
    if (i < options.observers.size()) setup.observer = options.observers[i];
    robots_.push_back(std::make_unique<HeadlessRobot>(setup));
  }
}

Result<void> HeadlessContest::load(const bhdl::Program& program) {
  for (auto& robot : robots_)
    if (const auto loaded = robot->load(program); !loaded)
      return Error{robot->name() + ": " + loaded.error().message};
  return {};
}

Result<void> HeadlessContest::run() {
  if (auto ready = wait_for_robots(); !ready) return ready;
  start();
  while (world_->referee().phase() == Phase::kRunning) {
    if (auto obeyed = obey_orders(); !obeyed) return obeyed;
    step();
    for (auto& robot : robots_) robot->note(World::kStep_s);
    if (options_.after_step) options_.after_step(clock_.now());
    if (options_.trace && (step_ - started_) % kStepsASecond == 0) write_trace();
  }
  return {};
}

Result<void> HeadlessContest::obey_orders() {
  for (; obeyed_ < options_.orders.size(); ++obeyed_) {
    const auto& [step, order] = options_.orders[obeyed_];
    if (step > step_ - started_) return {};
    if (const auto done = instructor_.carry_out(order); !done) return done.error();
  }
  return {};
}

Result<void> HeadlessContest::wait_for_robots() {
  for (auto& robot : robots_)
    while (!robot->connected()) {
      if (step_ >= kMostWait) {
        std::string message = robot->name() + " did not come up";
        for (const auto& problem : robot->problems()) message += ": " + problem;
        return Error{message};
      }
      step();
    }
  return {};
}

void HeadlessContest::start() {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    if (options_.start)
      robots_[i]->restore(options_.start->robots.at(i).program);
    else
      world_->robot(i).push_bumpers(kPushedSwitches);
  }
  started_ = step_;
  bumpers_released_ = step_ + kPush;
  world_->referee().start();
}

void HeadlessContest::step() {
  const Time now = clock_.now();
  for (auto& robot : robots_) robot->run_board(now);
  take_pictures(now);
  if (step_ % kTickSteps == 0)
    for (auto& robot : robots_) robot->tick();
  if (step_ == bumpers_released_)
    for (std::size_t i = 0; i < robots_.size(); ++i) world_->robot(i).push_bumpers(0);
  world_->step();
  clock_.advance(kStep);
  ++step_;
}

void HeadlessContest::take_pictures(Time now) {
  // The cameras take their pictures in different steps, which also spreads the work.
  for (std::size_t i = 0; i < robots_.size(); ++i)
    if ((step_ + i * 3) % picture_steps_ == 0) {
      look_at(*world_, scene_);
      robots_[i]->take_picture(now);
    }
}

std::uint64_t HeadlessContest::hash() const {
  robot::StateHash hash;
  world_->hash_into(hash);
  for (const auto& robot : robots_) robot->executive().hash_into(hash);
  return hash.value();
}

void HeadlessContest::write_trace() const {
  for (const auto& robot : robots_) {
    const Pose2 pose = robot->body().pose();
    const Pose2 believed = robot->believed_pose();
    const auto held = robot->body().gripper().held();
    const nlohmann::ordered_json line{
        {"time_s", std::round(world_->referee().elapsed_s() * 100) / 100},
        {"robot", robot->name()},
        {"state", robot->executive().state_name()},
        {"x_m", pose.position_m.x()},
        {"y_m", pose.position_m.y()},
        {"heading_rad", wrap_angle(pose.heading_rad)},
        {"believed_x_m", believed.position_m.x()},
        {"believed_y_m", believed.position_m.y()},
        {"believed_heading_rad", wrap_angle(believed.heading_rad)},
        {"bumpers", robot->body().bumpers()},
        {"beam_broken", robot->body().gripper().beam_broken()},
        {"holds", held ? (held->kind == BodyKind::kPiece ? "piece" : "furniture") : ""},
        {"stuck_s", robot->statistics().stuck.stuck_s()}};
    *options_.trace << ordered_json_text(line) << '\n';
  }
}

}  // namespace galilean::sim
