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
  std::string name;        ///< a transition's: the state that it leaves; on_swap's: the old state
  std::string type;        ///< a component's
  std::string transition;  ///< what makes it fire: "gripper[0] is 1"
  std::string attribute;   ///< what of it changed; empty: the whole
  std::string entry;       ///< the input whose gain changed, where one did
  std::optional<Value> from;
  std::optional<Value> to;
  Unit unit = unit::kNone;
};

[[nodiscard]] std::string_view to_string(Change::Kind kind) noexcept;
/// "motor_schema", as JSON names it.
[[nodiscard]] std::string_view to_string(Change::What what) noexcept;

/// "~ motor schema noise 'wander': persistence was 5 s, is 8 s"
[[nodiscard]] std::string in_words(const Change& change);
/// {kind, what, name} and those of type, transition, attribute, entry, from, to and unit that say
/// something.
void to_json(nlohmann::json& json, const Change& change);

}  // namespace galilean::bhdl
