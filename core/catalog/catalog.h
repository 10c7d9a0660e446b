// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/catalog/role.h"
#include "core/catalog/unit.h"
#include "core/catalog/value.h"
#include "core/result.h"

namespace galilean {

/// The section of a program that a component belongs to.
enum class ComponentKind {
  kInputDevice,
  kOutputDevice,
  kVariable,
  kPerceptualSchema,
  kMotorSchema
};
[[nodiscard]] std::string_view to_string(ComponentKind kind) noexcept;

enum class AttributeType {
  kFlag,     ///< yes or no (also true/false, 1/0)                  -> bool
  kNumber,   ///< 1.5                                              -> double
  kInteger,  ///< 3                                                -> double, whole
  kPair,     ///< <1, 2> or (1, 2)                                 -> Vec2
  kText,     ///< "words"                                          -> std::string
  kChoice,   ///< "valid", one of `choices`                        -> std::string
  kNumbers,  ///< 200 200 -200 -200                                -> std::vector<double>
  kName,     ///< "trash": what `refers_to` says                   -> std::string
  kNames     ///< "trash" "basket"                                 -> std::vector<std::string>
};
[[nodiscard]] std::string_view to_string(AttributeType type) noexcept;

/// How a component uses the variable that an attribute names.
enum class Access { kNone, kRead, kWrite, kUpdate };
[[nodiscard]] std::string_view to_string(Access access) noexcept;

struct AttributeSpec {
  std::string name;
  std::vector<std::string>
      aliases;  ///< spellings that still load, with a hint (the paper's misprints)
  AttributeType type = AttributeType::kText;
  Unit unit = unit::kNone;
  std::optional<Value> default_value;  ///< in the unit named above; none: must be given
  double minimum = -std::numeric_limits<double>::infinity();  ///< in the unit named above
  double maximum = std::numeric_limits<double>::infinity();
  std::size_t count = 0;  ///< of numbers or names that must be given; 0: any
  std::vector<std::string> choices;
  std::string refers_to;     ///< of a name: a variable's type ("locate"), "variable" (of any type),
                             ///< "state", "perceptual_schema", "motor_schema"
  std::string one_for_each;  ///< of a list that may be left out: the list that it has to match in
                             ///< number
  std::string bit_of;     ///< of a whole number that says which bit of a bits variable is written:
                          ///< the attribute that names the variable; less than 0: all bits
  std::string only_with;  ///< name of an optional attribute without which nobody reads this one
  std::string only_without;  ///< the same of one with which nobody reads it
  Access access = Access::kNone;
  Role role = Role::kNone;
  std::string of;  ///< with a role: the attribute that it belongs to; of a channel: its name
  std::string help;

  [[nodiscard]] bool required() const noexcept { return !default_value.has_value(); }
};

/// What every motor schema takes besides its own attributes: its force is multiplied by it.
inline constexpr const char* kGainAttribute = "gain";

struct ComponentSpec {
  std::string name;
  ComponentKind kind = ComponentKind::kVariable;
  std::string help;
  std::vector<AttributeSpec> attributes;
  std::string drives;  ///< of a motor schema: the device that it commands, where the last to do so
                       ///< in a tick wins; empty: none

  [[nodiscard]] const AttributeSpec* find(
      std::string_view attribute) const noexcept;  ///< by name or alias
  /// Returns the first attribute that has the role; nullptr if none has.
  [[nodiscard]] const AttributeSpec* find(Role role) const noexcept;
};

/// What components exist and what they take: plain data, so that whoever checks a program needs no
/// robot. The build writes the robot's as JSON; a live robot publishes its own.
struct Catalog {
  std::vector<ComponentSpec> components;

  [[nodiscard]] const ComponentSpec* find(std::string_view component) const noexcept;
};

void to_json(nlohmann::json& json, const Catalog& catalog);
/// Errors name the component and attribute that could not be read.
[[nodiscard]] Result<Catalog> catalog_from_json(std::string_view text);
[[nodiscard]] std::string catalog_to_json(const Catalog& catalog);

}  // namespace galilean
