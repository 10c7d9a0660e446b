#pragma once

#include <optional>
#include <string>

#include "bhdl/program.h"
#include "core/catalog/catalog.h"
#include "core/clock.h"
#include "core/wire/messages.h"

namespace galilean::monitor {

/// Tells from a robot's variables whether it holds something: its program says in which bits its
/// gripper_scanner puts the beam and the servo. What stands in the closed gripper for kSettled is
/// held; before, it may still slip out.
class Grasp {
 public:
  static constexpr Duration kSettled = std::chrono::milliseconds(1500);

  /// What a program says of the gripper; a program without gripper_scanner says nothing.
  void note(const msg::Program& program, const Catalog& catalog);
  void note(const msg::Variables& variables, Time now);
  [[nodiscard]] bool holds(Time now) const {
    return closed_on_something_ && now - since_ >= kSettled;
  }

 private:
  struct Bits {
    std::string variable;
    unsigned beam = 0;
    unsigned closed = 0;
  };
  std::optional<Bits> bits_;
  bool closed_on_something_ = false;
  Time since_{};
};

}  // namespace galilean::monitor
