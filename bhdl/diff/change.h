// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "core/catalog/unit.h"
#include "core/catalog/value.h"

namespace galilean::bhdl {

/// One difference between two programs. Values are in the catalog's units.
struct Change {
  enum class Kind { kAdded, kRemoved, kChanged, kReordered };
  enum class What {
    kStartState,
    kState,
    kTransition,
    kOnSwap,
    kDevice,
    kVariable,
    kPerceptualSchema,
    kMotorSchema
  };

  Kind kind = Kind::kChanged;
  What what = What::kState;
  std::string name;        ///< of a transition: the state that it leaves; of on_swap: the old state
  std::string type;        ///< of a component
  std::string transition;  ///< the cause that makes it fire: "gripper[0] is 1"
  std::string attribute;   ///< the attribute that changed; empty: the whole
  std::string entry;       ///< the input whose gain changed; empty: none
  std::optional<Value> from;
  std::optional<Value> to;
  Unit unit = unit::kNone;
};

[[nodiscard]] std::string_view to_string(Change::Kind kind) noexcept;
/// Returns the name in JSON, such as "motor_schema".
[[nodiscard]] std::string_view to_string(Change::What what) noexcept;

/// Returns words such as "~ motor schema noise 'wander': persistence was 5 s, is 8 s".
[[nodiscard]] std::string in_words(const Change& change);
/// Writes {kind, what, name}, and those of type, transition, attribute, entry, from, to and unit
/// that are not empty.
void to_json(nlohmann::json& json, const Change& change);

}  // namespace galilean::bhdl
