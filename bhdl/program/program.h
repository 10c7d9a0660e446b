// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "bhdl/program/expectation.h"
#include "bhdl/source/location.h"
#include "bhdl/source/source_file.h"
#include "core/catalog/attribute_values.h"
#include "core/catalog/catalog.h"

namespace galilean::bhdl {

/// An instance of a component of the catalog.
struct Component {
  std::string type;  ///< the component's name in the catalog
  std::string name;  ///< "aso0"; a device's is its type
  ComponentKind kind = ComponentKind::kVariable;
  AttributeValues attributes;  ///< SI, defaults filled in
  Location location;
};

enum class BitUpdate { kSame, kSet, kClear, kToggle };
[[nodiscard]] std::string_view to_string(BitUpdate update) noexcept;

/// A transition of the state that holds it.
struct Condition {
  std::string bits_variable;
  unsigned bit_index = 0;
  bool bit_value = true;
  BitUpdate bit_update = BitUpdate::kSame;
  std::string new_state;
  std::vector<std::string> reset_variables;
  Location location;
};

struct State {
  std::string name;
  std::vector<std::string> perceptual_schemas;  ///< run in this order
  std::vector<std::string> motor_schemas;       ///< run in this order
  std::vector<Condition> conditions;            ///< tried in this order; the first that holds fires
  Location location;
};

/// A checked program: every name in it exists and has the right type, every value is in its range.
struct Program {
  std::string name;  ///< the main file's name without its folder
  std::string hash;  ///< SHA-256 over paths and texts of all files, hexadecimal
  std::vector<SourceFile>
      files;  ///< the main file first, then its includes in the order of reading
  std::vector<Component> devices;
  std::vector<Component> variables;
  std::vector<Component> perceptual_schemas;
  std::vector<Component> motor_schemas;
  std::vector<State> states;
  std::string start_state;  ///< as `start_state:` says, else the first state
  /// The on_swap mappings: the state to go on in when a program that was in state `first` is
  /// replaced.
  std::map<std::string, std::string> on_swap;
  std::vector<Expectation> expectations;  ///< robots ignore them

  [[nodiscard]] const State* find_state(std::string_view state) const noexcept;
};

}  // namespace galilean::bhdl
