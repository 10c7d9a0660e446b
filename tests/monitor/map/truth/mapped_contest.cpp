// SPDX-License-Identifier: BSD-3-Clause
#include "tests/monitor/map/truth/mapped_contest.h"

#include <stdexcept>

#include "robot/components.h"
#include "sim/headless/programs.h"

namespace galilean::monitor {
namespace {

constexpr Duration kReport = std::chrono::milliseconds(100);
constexpr Duration kUpdate = std::chrono::milliseconds(200);
constexpr Duration kLook = std::chrono::seconds(1);

template <class T>
T required(Result<T> result) {
  if (!result) throw std::runtime_error(result.error().message);
  return std::move(result).value();
}

}  // namespace

MappedContest::MappedContest(const Options& options)
    : map_(std::chrono::seconds(2), options.group_size) {
  robot::add_components(components_);
  sim::HeadlessOptions how{
      .robots = options.robots, .seed = options.seed, .duration_s = options.duration_s};
  how.after_step = [this](Time now) { after_step(now); };
  for (std::size_t i = 0; i < options.robots; ++i) {
    auto& telemetry = telemetry_.emplace_back(std::make_unique<Telemetry>());
    telemetry->compose.emplace(sim::robot_name(i), stopped_);
    how.observers.push_back(&telemetry->tap);
  }
  const auto scenario = required(sim::load_scenario(options.scenario));
  const auto program = required(sim::load_program("office_cleanup", components_.catalog()));
  contest_ = required(sim::HeadlessContest::make(scenario, components_, program, how));
  for (std::size_t i = 0; i < options.robots; ++i)
    map_.start_at(sim::robot_name(i), options.starts == Starts::kMeasured
                                          ? contest_->world().robot(i).pose()
                                          : scenario.starts[i]);
}

void MappedContest::run(
    const std::function<void(const MappedContest&, const msg::ObjectMap&)>& look) {
  look_ = look;
  if (const auto ran = contest_->run(); !ran) throw std::runtime_error(ran.error().message);
}

void MappedContest::after_step(Time now) {
  now_ = now;
  for (const auto& tell : on_step) tell();
  for (std::size_t i = 0; i < telemetry_.size(); ++i) report(i);
  if (now < next_update_) return;
  next_update_ = now + kUpdate;
  map_.update(now);
  if (now < next_look_) return;
  next_look_ = now + kLook;
  look_(*this, map_.objects(now, kEpoch_ns + now.time_since_epoch().count()));
}

void MappedContest::report(std::size_t robot) {
  Telemetry& telemetry = *telemetry_[robot];
  while (telemetry.tap.next_event()) {
  }
  if (!telemetry.tap.take()) return;
  const robot::Snapshot& snapshot = telemetry.tap.newest();
  if (!snapshot.program) return;
  if (!telemetry.program) {
    telemetry.program = contest_->robot(robot).executive().description(snapshot.program);
    map_.add(telemetry.compose->catalog(components_.catalog()), now_);
    map_.add(telemetry.compose->program(*telemetry.program), now_);
  }
  if (snapshot.frame != std::exchange(telemetry.last_frame, snapshot.frame)) {
    const auto sightings = telemetry.compose->sightings(snapshot, *telemetry.program);
    for (const auto& tell : on_sightings) tell(robot, sightings);
    map_.add(sightings, now_);
  }
  if (now_ >= telemetry.next_report) report_regularly(telemetry, snapshot);
}

void MappedContest::report_regularly(Telemetry& telemetry, const robot::Snapshot& snapshot) {
  telemetry.next_report = now_ + kReport;
  map_.add(telemetry.compose->state(snapshot, telemetry.program.get(), {}), now_);
  map_.add(telemetry.compose->variables(snapshot, *telemetry.program), now_);
}

}  // namespace galilean::monitor
