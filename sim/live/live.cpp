// SPDX-License-Identifier: BSD-3-Clause
#include "sim/live/live.h"

#include <chrono>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <thread>

#include "core/json_text.h"
#include "core/wire/refusals.h"
#include "sim/control/truth.h"

namespace galilean::sim {
namespace {

constexpr auto kStep = std::chrono::milliseconds(10);
constexpr std::uint64_t kStepsASecond = 100;
constexpr auto kPublishPeriod = std::chrono::milliseconds(100);
/// The longest delay that the simulator catches up. If the machine was busy or asleep for longer,
/// the rest of that time is dropped. While it catches up, no new commands can come from the robots:
/// a longer time would let the boards' stop timers (110 ms) run out.
constexpr auto kMostBehind = std::chrono::milliseconds(60);

BootMemory boot_memory(const LiveOptions& options, const std::string& robot) {
  return options.boards.empty() ? BootMemory() : BootMemory(options.boards / (robot + ".boots"));
}

}  // namespace

Result<std::unique_ptr<LiveContest>> LiveContest::make(const Scenario& scenario,
                                                       const LiveOptions& options) {
  auto world = World::make(scenario, options.robots, options.seed);
  if (!world) return world.error();
  auto folder = RunFolder::make(options.run);
  if (!folder) return folder.error();
  auto participant = wire::Participant::join("sim", options.domain);
  if (!participant) return participant.error();
  participant.value()->refusals().tell_with([](const std::string& sentence) {
    std::cerr << "galilean-sim: " + sentence + "\n" << std::flush;
  });
  std::unique_ptr<LiveContest> contest(new LiveContest(scenario, std::move(world).value(),
                                                       std::move(folder).value(),
                                                       std::move(participant).value(), options));
  for (auto& robot : contest->robots_)
    if (const auto plugged = robot->plug_in(); !plugged) return plugged.error();
  for (const auto& robot : contest->robots_)
    if (!robot->problem().empty()) std::cerr << "galilean-sim: " << robot->problem() << "\n";
  return contest;
}

LiveContest::LiveContest(const Scenario& scenario, std::unique_ptr<World> world, RunFolder folder,
                         std::unique_ptr<wire::Participant> participant, const LiveOptions& options)
    : options_(options),
      world_(std::move(world)),
      folder_(std::move(folder)),
      participant_(std::move(participant)),
      desk_(*participant_, options.run),
      score_(*participant_),
      start_(*world_),
      instructor_(*world_, pace_, start_),
      scene_(scene_of(scenario)),
      renderer_({}, scenario.camera, Random(options.seed).child("camera")),
      picture_steps_(static_cast<std::uint64_t>(
          std::lround(static_cast<double>(kStepsASecond) / scenario.camera.rate_hz))) {
  for (std::size_t i = 0; i < options.robots; ++i)
    robots_.push_back(std::make_unique<LiveRobot>(*world_, i, folder_.path().string(),
                                                  "/galilean-" + options.run + "-" + robot_name(i),
                                                  boot_memory(options, robot_name(i))));
}

std::string LiveContest::ready_line() const {
  nlohmann::ordered_json robots = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    // This is the scenario's place before the jitter: what a person with a tape would measure.
    const Pose2& start = world_->scenario().starts[i];
    robots.push_back({{"name", robots_[i]->name()},
                      {"serial", robots_[i]->serial_path()},
                      {"camera", "ring:" + robots_[i]->ring_name()},
                      {"start",
                       {{"x_m", start.position_m.x()},
                        {"y_m", start.position_m.y()},
                        {"heading_deg", start.heading_rad * 180 / kPi}}}});
  }
  return ordered_json_text({{"ready", true},
                            {"run", options_.run},
                            {"scenario", world_->scenario().name},
                            {"folder", folder_.path().string()},
                            {"robots", robots}});
}

std::string LiveContest::score_line() const {
  const Referee& referee = world_->referee();
  return ordered_json_text({{"phase", to_string(referee.phase())},
                            {"elapsed_s", referee.elapsed_s()},
                            {"pieces", world_->objects().pieces().size()},
                            {"deposited", referee.deposited()},
                            {"collisions", referee.collisions()},
                            {"score", referee.score()}});
}

double LiveContest::now_s() const noexcept {
  return static_cast<double>(step_) / static_cast<double>(kStepsASecond);
}

void LiveContest::run(const std::atomic<bool>& ending) {
  auto due = std::chrono::steady_clock::now();
  while (!ending) {
    obey_orders();
    if (pace_.take_step())
      step();
    else
      stand_still();
    if (std::chrono::steady_clock::now() - published_ >= kPublishPeriod) publish();
    due += pace_.real_time(kStep);
    const auto now = std::chrono::steady_clock::now();
    if (now - due > kMostBehind) due = now;
    std::this_thread::sleep_until(due);
  }
}

void LiveContest::obey_orders() {
  const auto orders = desk_.take();
  for (const auto& order : orders) carry_out(order);
}

void LiveContest::carry_out(const msg::SimulationOrder& order) {
  const auto done = instructor_.carry_out(order);
  if (done && order.order.ends_with("_contest")) starts_by_itself_ = false;
  if (done) apply_faults();
  publish();  // before the answer, so that who hears the answer can read what changed
  msg::SimulationEvent event;
  event.order_id = order.id;
  event.author = order.author;
  event.order = order.order;
  event.subject = order.subject;
  event.done = done.ok();
  event.text = done ? done.value() : done.error().message;
  event.step = step_;
  event.simulated_s = now_s();
  desk_.tell(std::move(event));
}

void LiveContest::publish() {
  published_ = std::chrono::steady_clock::now();
  score_.show(*world_);
  auto truth = truth_of(*world_, pace_);
  truth.step = step_;
  truth.simulated_s = now_s();
  desk_.show(std::move(truth));
}

void LiveContest::stand_still() {
  for (auto& robot : robots_) robot->ignore_commands();
}

void LiveContest::step() {
  if (step_ % kStepsASecond == 0) apply_faults();
  start_when_ready();
  const auto now_ms = static_cast<std::uint32_t>(step_ * static_cast<std::uint64_t>(kStep.count()));
  for (auto& robot : robots_) robot->run_board(now_ms);
  take_pictures();
  world_->step();
  ++step_;
}

void LiveContest::apply_faults() {
  for (auto& robot : robots_)
    if (const auto plugged = robot->apply_faults(options_.faults, now_s()); !plugged)
      std::cerr << "galilean-sim: " << plugged.error().message << "\n";
}

void LiveContest::start_when_ready() {
  start_.before_step();
  if (starts_by_itself_ && world_->referee().phase() == Phase::kWaiting && anybody_moves())
    world_->referee().start();
  if (!starts_by_itself_ || !options_.autostart_s) return;
  if (!connected_step_) {
    for (const auto& robot : robots_)
      if (!robot->connected()) return;
    connected_step_ = step_;
  }
  const std::uint64_t push =
      *connected_step_ + static_cast<std::uint64_t>(*options_.autostart_s * kStepsASecond);
  if (step_ == push) start_.start();
}

bool LiveContest::anybody_moves() const {
  for (std::size_t i = 0; i < robots_.size(); ++i)
    if (world_->robot(i).powered()) return true;
  return false;
}

void LiveContest::take_pictures() {
  // The pictures are taken in different steps, because the boards' control loops must not wait.
  for (std::size_t i = 0; i < robots_.size(); ++i)
    if ((step_ + i * 3) % picture_steps_ == 0) {
      look_at(*world_, scene_);
      robots_[i]->take_picture(scene_, renderer_);
    }
}

}  // namespace galilean::sim
