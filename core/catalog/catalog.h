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
      aliases;  ///< other spellings, from the paper's misprints; they load with a hint
  AttributeType type = AttributeType::kText;
  Unit unit = unit::kNone;
  std::optional<Value> default_value;  ///< in `unit`; none: a program must give a value
  double minimum = -std::numeric_limits<double>::infinity();  ///< in `unit`
  double maximum = std::numeric_limits<double>::infinity();
  std::size_t count = 0;  ///< how many numbers or names must be given; 0: any number of them
  std::vector<std::string> choices;
  std::string refers_to;     ///< what a name refers to: a variable's type ("locate"), "variable"
                             ///< (of any type), "state", "perceptual_schema", "motor_schema"
  std::string one_for_each;  ///< of an optional list: the list whose number of entries it must have
  std::string bit_of;     ///< of the index of a bit: the attribute that names the bits variable; an
                          ///< index below 0 means all its bits
  std::string only_with;  ///< the attribute without which no component reads this one; empty: none
  std::string only_without;  ///< the attribute with which no component reads this one; empty: none
  Access access = Access::kNone;
  Role role = Role::kNone;
  std::string of;  ///< the attribute that the role refers to; with kChannel the channel's name
  std::string help;

  [[nodiscard]] bool required() const noexcept { return !default_value.has_value(); }
};

/// The attribute that every motor schema has besides its own. The schema's force is multiplied by
/// it.
inline constexpr const char* kGainAttribute = "gain";

struct ComponentSpec {
  std::string name;
  ComponentKind kind = ComponentKind::kVariable;
  std::string help;
  std::vector<AttributeSpec> attributes;
  std::string drives;  ///< of a motor schema: the device that it commands; the last such schema of
                       ///< a tick wins; empty: none
  std::vector<std::string> needs;  ///< of a schema: the devices without which it has no effect
  std::string configures;          ///< of settings: the device that they are for; empty: the one
                                   ///< that is called as the component is

  [[nodiscard]] const AttributeSpec* find(
      std::string_view attribute) const noexcept;  ///< by name or alias; nullptr: there is none
  /// Returns the first attribute that has the role, or nullptr if none has it.
  [[nodiscard]] const AttributeSpec* find(Role role) const noexcept;
  /// Returns the robot's device that a program names by this component. Requires: these are the
  /// settings of a device.
  [[nodiscard]] const std::string& device() const noexcept {
    return configures.empty() ? name : configures;
  }
};

/// The components that exist and the attributes that they take. It is plain data, so that a checker
/// of programs needs no robot. The build writes the robot's catalog as JSON. A live robot publishes
/// its own.
struct Catalog {
  std::vector<ComponentSpec> components;

  [[nodiscard]] const ComponentSpec* find(std::string_view component) const noexcept;
};

void to_json(nlohmann::json& json, const Catalog& catalog);
/// Errors: the text is not the JSON of a catalog. The error names the component that could not be
/// read.
[[nodiscard]] Result<Catalog> catalog_from_json(std::string_view text);
[[nodiscard]] std::string catalog_to_json(const Catalog& catalog);

}  // namespace galilean
