// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/result.h"
#include "core/wire/messages.h"
#include "sim/control/contest_start.h"
#include "sim/control/pace.h"
#include "sim/world/world.h"

namespace galilean::sim {

/// Carries out an instructor's orders on the world, its pace and its contest. It is called by the
/// simulation's thread between two steps, so that the same orders before the same steps give the
/// same run.
class Instructor {
 public:
  Instructor(World& world, Pace& pace, ContestStart& contest)
      : world_(world), pace_(pace), contest_(contest) {}

  /// Returns what was done, such as "moved io to (2.00, 1.50) m".
  /// Errors: the order cannot be carried out, and nothing changed.
  Result<std::string> carry_out(const msg::SimulationOrder& order);

 private:
  using Answer = Result<std::string>;
  using Order = msg::SimulationOrder;

  Answer pause(const Order&);
  Answer go_on(const Order&);
  Answer step(const Order& order);
  Answer set_rate(const Order& order);
  Answer move(const Order& order);
  Answer push(const Order& order);
  Answer drop(const Order& order);
  Answer remove(const Order& order);
  Answer break_part(const Order& order);
  Answer mend(const Order& order);
  Answer start_contest(const Order&);
  Answer pause_contest(const Order&);
  Answer reset_contest(const Order&);

  /// Errors: nothing is called so; the error names what is.
  [[nodiscard]] Result<b2Body*> body(const Order& order) const;
  [[nodiscard]] Result<RobotBody*> robot(const Order& order) const;
  /// Errors: the place is outside of the arena.
  [[nodiscard]] Result<void> inside(const Order& order) const;

  World& world_;
  Pace& pace_;
  ContestStart& contest_;
};

}  // namespace galilean::sim
