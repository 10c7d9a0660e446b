// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "robot/executive/state_hash.h"
#include "sim/scenario/scenario.h"
#include "sim/world/objects.h"
#include "sim/world/physics.h"
#include "sim/world/referee.h"
#include "sim/world/robot_body.h"

namespace galilean::sim {

/// The office, its pieces, its robots and their referee. All that happens follows from the
/// scenario, the seed and the boards' outputs.
class World {
 public:
  static constexpr double kStep_s = 0.01;

  [[nodiscard]] static Result<std::unique_ptr<World>> make(const Scenario& scenario,
                                                           std::size_t robots, std::uint64_t seed);
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  /// Advances physics by `kStep_s`, and also the contest's clock while it runs.
  void step();

  [[nodiscard]] const Scenario& scenario() const noexcept { return scenario_; }
  [[nodiscard]] RobotBody& robot(std::size_t index) { return *robots_[index]; }
  [[nodiscard]] const RobotBody& robot(std::size_t index) const { return *robots_[index]; }
  [[nodiscard]] std::size_t robot_count() const noexcept { return robots_.size(); }
  [[nodiscard]] const Objects& objects() const noexcept { return objects_; }
  [[nodiscard]] Referee& referee() noexcept { return referee_; }
  [[nodiscard]] const Referee& referee() const noexcept { return referee_; }
  /// Returns the body that is called so, or nullptr if none is in the arena: a robot by its name,
  /// "can_3", "basket_1" or "chair_2".
  [[nodiscard]] b2Body* find_body(std::string_view name) const;
  /// Returns the name of a body, which for what never moves is "a wall" or "table_1".
  [[nodiscard]] std::string name_of(BodyTag tag) const;
  /// Puts a body, which is no wall or furniture that is fixed, at a place, where it stands still.
  void place(b2Body& body, const Pose2& pose);
  /// Adds a piece and returns its name.
  std::string drop(const PlacedPiece& piece);
  /// Takes a piece out of the arena. It does not count as thrown away.
  void remove_piece(std::size_t index);
  /// Puts every body back to where it was at first, and the referee's clock and sheet to zero.
  /// Parts that are broken stay broken.
  void reset();
  [[nodiscard]] const b2World& bodies() const noexcept { return physics_.world(); }
  [[nodiscard]] double to_nearest_basket_m(const Vec2& from_m) const;

  /// Adds poses and velocities of all bodies and the referee's sheet, to the last bit.
  void hash_into(robot::StateHash& hash) const;

 private:
  World(const Scenario& scenario, const std::vector<PlacedPiece>& pieces, std::size_t robots,
        const Random& random);
  void judge_release(std::size_t robot);

  void let_go_of(BodyTag body);

  Scenario scenario_;
  Physics physics_;
  Objects objects_;
  std::vector<std::unique_ptr<RobotBody>> robots_;
  std::vector<Pose2> first_poses_;  ///< of the robots
  Referee referee_;
};

/// Returns "io", "ganymede", "callisto", then the other moons in the order of their numbers. After
/// those come "robot_17" and so on.
[[nodiscard]] std::string robot_name(std::size_t index);

}  // namespace galilean::sim
