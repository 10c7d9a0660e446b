#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "bhdl/program/program.h"
#include "core/catalog/catalog.h"
#include "core/clock.h"
#include "core/wire/messages.h"

namespace galilean::monitor {

/// Tells from a robot's variables what it feels: its catalog says which schemas write the bits of
/// bumpers and of the gripper's beam, and its program in which variables. In a state that opens the
/// gripper and does not look at the beam, what the robot had is put down.
class Senses {
 public:
  /// What breaks the gripper's beam for so long moves with the robot, whether the jaws are closed
  /// or push it; what is shorter there passes by.
  static constexpr Duration kSettled = std::chrono::milliseconds(300);
  /// A bumper that was let go may be touched still.
  static constexpr Duration kLetGo = std::chrono::milliseconds(300);

  /// What a program says of gripper and bumpers; one without the schemas says nothing.
  void note(const msg::Program& program, const Catalog& catalog);
  void note(const msg::Variables& variables, Time now);
  void note(const msg::RobotState& state) { lets_go_now_ = lets_go_.contains(state.state); }
  [[nodiscard]] bool holds(Time now) const {
    return beam_broken_ && !lets_go_now_ && now - since_ >= kSettled;
  }
  [[nodiscard]] bool touches(Time now) const { return touched_ && now - *touched_ <= kLetGo; }

 private:
  struct SensorBits {
    std::string variable;
    std::uint32_t mask = 0;  ///< one bit of it, or all
  };
  void note_bits(const bhdl::Component& schema, const Catalog& catalog);
  void note_states(const bhdl::Program& program, const Catalog& catalog);

  std::vector<SensorBits> beam_;
  std::vector<SensorBits> bumpers_;
  std::set<std::string> lets_go_;  ///< states
  bool lets_go_now_ = false;
  bool beam_broken_ = false;
  Time since_{};
  std::optional<Time> touched_;
};

}  // namespace galilean::monitor
