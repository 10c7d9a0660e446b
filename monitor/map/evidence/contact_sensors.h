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

/// A robot's bumpers and its gripper's light beam, as its variables tell them. The robot's catalog
/// says which schemas write these bits, and its program into which variables. In a state that opens
/// the gripper and does not look at the beam, what the robot held is put down.
class ContactSensors {
 public:
  /// An object that breaks the beam for so long moves with the robot, whether the jaws are closed
  /// or push it. What breaks it for a shorter time passes by.
  static constexpr Duration kSettled = std::chrono::milliseconds(300);
  /// A bumper that was released so short a time ago may be touched still.
  static constexpr Duration kReleased = std::chrono::milliseconds(300);

  /// Reads where the robot's program puts gripper and bumpers. A program without those schemas, or
  /// with errors, tells neither.
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
