// SPDX-License-Identifier: BSD-3-Clause
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

/// The state of a robot's bumpers and of its gripper's light beam, from the robot's variables. The
/// catalog says which schemas write these bits, and the program says into which variables. In a
/// state that opens the gripper and does not read the beam, the robot puts down what it held.
class ContactSensors {
 public:
  /// An object that breaks the beam for so long moves with the robot, whether the jaws are closed
  /// or push it. What breaks it for a shorter time passes by.
  static constexpr Duration kSettled = std::chrono::milliseconds(300);
  /// A bumper counts as touched for this long after its release.
  static constexpr Duration kReleased = std::chrono::milliseconds(300);

  /// Reads which bits of which variables the robot's program writes for the beam and the bumpers. A
  /// program with errors, or without those schemas, writes none.
  void set_program(const msg::Program& program, const Catalog& catalog);
  void update(const msg::Variables& variables, Time now);
  void update(const msg::RobotState& state) { opens_now_ = opens_.contains(state.state); }

  [[nodiscard]] bool is_holding(Time now) const {
    return beam_broken_ && !opens_now_ && now - broken_since_ >= kSettled;
  }
  [[nodiscard]] bool is_touching(Time now) const {
    return touched_ && now - *touched_ <= kReleased;
  }

 private:
  struct SensorBits {
    std::string variable;
    std::uint32_t mask = 0;  ///< one bit of it, or all
  };
  void note_bits(const bhdl::Component& schema, const Catalog& catalog);
  void note_states(const bhdl::Program& program, const Catalog& catalog);

  std::vector<SensorBits> beam_;
  std::vector<SensorBits> bumpers_;
  std::set<std::string> opens_;  ///< states in which a held object is put down
  bool opens_now_ = false;
  bool beam_broken_ = false;
  Time broken_since_{};
  std::optional<Time> touched_;  ///< when a bumper was last touched
};

}  // namespace galilean::monitor
