// SPDX-License-Identifier: BSD-3-Clause
#include "core/catalog/role.h"

#include <algorithm>
#include <array>
#include <span>
#include <stdexcept>

#include "core/catalog/catalog.h"
#include "core/catalog/wiring.h"
#include "core/variable/type_name.h"

namespace galilean {
namespace {

using enum AttributeType;

/// What a role demands of the attribute that has it.
struct RoleRule {
  Role role;
  std::string_view word;
  std::array<AttributeType, 2> types;
  std::string_view written;  ///< type of the variable that the attribute must write; empty: none
  std::string_view of;       ///< type of the variable that `of` must name; empty: any `of`
};

constexpr std::string_view kNothing;
constexpr std::string_view kForce = variable_type_name<Force>();
constexpr std::string_view kImage = variable_type_name<Image>();
constexpr std::string_view kLocate = variable_type_name<Locate>();
constexpr std::array<AttributeType, 2> kAnyNumber{kNumber, kInteger};

constexpr std::array<RoleRule, 15> kRules{{
    {Role::kGain, "gain", {kNumber, kNumbers}, kNothing, kForce},
    {Role::kChannel, "channel", {kName, kName}, kImage, kNothing},
    {Role::kSighting, "sighting", {kName, kName}, kLocate, kImage},
    {Role::kThreshold, "threshold", kAnyNumber, kNothing, kImage},
    {Role::kPolarity, "polarity", {kChoice, kChoice}, kNothing, kImage},
    {Role::kLeastArea, "least_area", kAnyNumber, kNothing, kImage},
    {Role::kCertaintyAtLeast, "certainty_at_least", kAnyNumber, kNothing, kLocate},
    {Role::kCertaintyBelow, "certainty_below", kAnyNumber, kNothing, kLocate},
    {Role::kDistanceAtMost, "distance_at_most", kAnyNumber, kNothing, kLocate},
    {Role::kTimeAtLeast, "time_at_least", kAnyNumber, kNothing, kNothing},
    {Role::kBumper, "bumper", {kInteger, kInteger}, kNothing, kNothing},
    {Role::kGripperBeam, "gripper_beam", {kInteger, kInteger}, kNothing, kNothing},
    {Role::kGripperCommand, "gripper_command", {kChoice, kChoice}, kNothing, kNothing},
    {Role::kCameraHeight, "camera_height", kAnyNumber, kNothing, kNothing},
    {Role::kCameraForward, "camera_forward", kAnyNumber, kNothing, kNothing},
}};

const RoleRule& rule_of(Role role) {
  return *std::ranges::find(kRules, role, &RoleRule::role);
}

bool writes(const AttributeSpec& attribute) noexcept {
  return attribute.access == Access::kWrite || attribute.access == Access::kUpdate;
}

bool is_bit(Role role) noexcept {
  return role == Role::kBumper || role == Role::kGripperBeam;
}

/// Returns why the attribute cannot have its role, or an empty text if it can.
std::string fault(const ComponentSpec& component, const AttributeSpec& attribute) {
  const RoleRule& rule = rule_of(attribute.role);
  if (std::ranges::find(rule.types, attribute.type) == rule.types.end())
    return "is of type " + std::string(to_string(attribute.type));
  if (!rule.written.empty() && !(writes(attribute) && attribute.refers_to == rule.written))
    return "writes no " + std::string(rule.written);
  if (is_bit(attribute.role) && attribute.bit_of.empty()) return "is not the index of a bit";
  if (attribute.role == Role::kChannel && attribute.of.empty()) return "names no channel";
  if (rule.of.empty()) return {};
  const AttributeSpec* meant = component.find(attribute.of);
  if (meant == nullptr) return "is of '" + attribute.of + "', which is no attribute";
  if (meant->refers_to != rule.of)
    return "is of '" + attribute.of + "', which names no " + std::string(rule.of);
  return {};
}

}  // namespace

std::string_view to_string(Role role) noexcept {
  return role == Role::kNone ? "none" : rule_of(role).word;
}

Role role_named(std::string_view word) noexcept {
  const auto found = std::ranges::find(kRules, word, &RoleRule::word);
  return found == kRules.end() ? Role::kNone : found->role;
}

void require_sound_roles(const ComponentSpec& component) {
  for (const auto& attribute : component.attributes) {
    if (attribute.role == Role::kNone) continue;
    if (const auto reason = fault(component, attribute); !reason.empty())
      throw std::logic_error("'" + attribute.name + "' of '" + component.name +
                             "' cannot have the role " + std::string(to_string(attribute.role)) +
                             ": it " + reason);
  }
}

std::vector<std::string> picture_channels(const Catalog& catalog) {
  std::vector<std::string> channels;
  for (const auto& component : catalog.components)
    for (const auto& attribute : component.attributes)
      if (attribute.role == Role::kChannel &&
          std::ranges::find(channels, attribute.of) == channels.end())
        channels.push_back(attribute.of);
  return channels;
}

}  // namespace galilean
