// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

#include "core/catalog/registry.h"
#include "core/clock.h"
#include "core/result.h"
#include "sim/control/instructor.h"
#include "sim/headless/headless_robot.h"
#include "sim/headless/situation.h"

namespace galilean::sim {

/// An instructor's order and the contest's step before which it is carried out; 0 is the first.
struct TimedOrder {
  std::uint64_t step = 0;
  msg::SimulationOrder order;
};

struct HeadlessOptions {
  std::size_t robots = 3;
  std::uint64_t seed = 1;
  double duration_s = 600;
  const TeamSituation* start = nullptr;  ///< the situation to go on from; null: the scenario's
                                         ///< start
  std::ostream* trace = nullptr;  ///< one JSON object a robot and simulated second; may be null
  std::vector<robot::TickObserver*> observers;  ///< of the robots, in their order; may be fewer
  std::function<void(Time now)> after_step;     ///< while the contest runs; may be empty
  std::vector<TimedOrder> orders;               ///< in the order of their steps
};

/// A contest in one process and one thread, as fast as the machine allows. It has the world and a
/// whole robot for each of its bodies, on a stepped clock. The same scenario, program and options
/// give the same bits.
///
///   each 10 ms: link and firmware · each 100 ms: a picture · each 50 ms: a tick · then the world
///
/// The referee waits until every robot is connected. Then it starts: it pushes a bumper of each
/// robot, or restores each robot's program from the situation.
class HeadlessContest {
 public:
  /// Requires: the program was checked against `components`, which must outlive the contest.
  [[nodiscard]] static Result<std::unique_ptr<HeadlessContest>> make(
      const Scenario& scenario, const Registry& components, const bhdl::Program& program,
      const HeadlessOptions& options);

  /// Runs the contest to its end. Errors: a robot never connected; the message is that robot's. Or
  /// an order cannot be carried out.
  Result<void> run();

  [[nodiscard]] const World& world() const noexcept { return *world_; }
  [[nodiscard]] std::size_t robot_count() const noexcept { return robots_.size(); }
  [[nodiscard]] const HeadlessRobot& robot(std::size_t index) const { return *robots_[index]; }
  [[nodiscard]] double simulated_s() const noexcept { return world_->referee().elapsed_s(); }
  /// Returns a hash of the state of all bodies, of the referee's sheet and of all executives.
  [[nodiscard]] std::uint64_t hash() const;

 private:
  HeadlessContest(const Scenario& scenario, const Registry& components,
                  std::unique_ptr<World> world, const HeadlessOptions& options);
  Result<void> load(const bhdl::Program& program);
  Result<void> wait_for_robots();
  void start();
  Result<void> obey_orders();
  void step();
  void take_pictures(Time now);
  void write_trace() const;

  HeadlessOptions options_;
  std::unique_ptr<World> world_;
  Pace pace_;
  ContestStart contest_start_;
  Instructor instructor_;
  std::size_t obeyed_ = 0;  ///< orders
  SteppedClock clock_;
  SteppedClock stopwatch_;  ///< stands still, so that no tick takes time
  Scene scene_;
  Renderer renderer_;
  std::vector<std::unique_ptr<HeadlessRobot>> robots_;
  std::uint64_t step_ = 0;
  std::uint64_t started_ = 0;           ///< the step in which the contest began
  std::uint64_t bumpers_released_ = 0;  ///< the step in which the referee releases them
  std::uint64_t picture_steps_;
};

}  // namespace galilean::sim
