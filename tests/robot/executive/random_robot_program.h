// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/random.h"

namespace galilean::robot {

/// Writes correct programs for the components of a real robot. The programs share some names of
/// states, variables (not always of the same type) and schemas. In every state the first and the
/// last schema of each kind, which share their names, note "perceive MARK" or "act MARK" in the
/// journal. Now and then one throws.
class RandomRobotProgram {
 public:
  explicit RandomRobotProgram(std::uint64_t seed) : random_(seed) {}

  [[nodiscard]] std::string draw(std::string_view mark);
  [[nodiscard]] std::uint32_t below(std::uint32_t count) { return random_.below(count); }
  [[nodiscard]] bool chance(std::uint32_t of) { return below(of) == 0; }

 private:
  using Names = std::vector<std::string>;

  void draw_variables();
  void draw_perceptual_schemas(std::string_view mark);
  void draw_motor_schemas(std::string_view mark);
  void draw_forces();
  void draw_states();
  void draw_state(const std::string& name);
  void draw_condition();
  void draw_on_swap();

  void add_variable(const std::string& type, const std::string& name);
  void add_schema(Names& kind, const std::string& type, const std::string& name,
                  const std::string& attributes);
  [[nodiscard]] const std::string& one_of(const Names& names);
  /// Returns the attribute with variables of that type, such as "name_variable: "trash" ".
  [[nodiscard]] std::string given(const std::string& attribute, const Names& names);
  [[nodiscard]] std::string some_of(const Names& names);

  Random random_;
  std::string text_;
  Names locates_, bits_, forces_, images_, perceptual_, motor_, states_;
};

}  // namespace galilean::robot
