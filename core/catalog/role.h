// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace galilean {

struct Catalog;
struct ComponentSpec;

/// What an attribute is to those who know no component by name: to viewers, to the map, to the
/// simulator. `of` is what AttributeSpec::of names.
enum class Role {
  kNone,
  kGain,              ///< number or numbers: the forces that `of` names count so many times
  kChannel,           ///< image that is written: viewers get it as the picture `of`
  kSighting,          ///< locate that is written: what was found in the image `of`
  kThreshold,         ///< number: from this brightness on a pixel of the image `of` stands out
  kPolarity,          ///< choice, bright or dark: dark, pixels below the threshold stand out
  kLeastArea,         ///< number: fewer pixels that touch are no object in the image `of`
  kCertaintyAtLeast,  ///< number: the bit is 1 while the certainty of the locate `of` is at least
                      ///< so
  kCertaintyBelow,    ///< number: the bit is 1 while the certainty of the locate `of` is below
  kDistanceAtMost,    ///< number: the bit is 1 while the locate `of` is at most so far away
  kTimeAtLeast,       ///< number: the bit is 1 once the state has lasted so long
  kBumper,            ///< index of a bit: that of the bumper with this number; less than 0: of all
  kGripperBeam,       ///< index of a bit: 1 while something stands in the gripper's beam
  kGripperCommand,    ///< choice, open or close: what the gripper is told to do
  kCameraHeight,      ///< number: of the lens over the floor
  kCameraForward      ///< number: of the lens in front of the robot's centre
};
/// The word that stands for it in the catalog's JSON.
[[nodiscard]] std::string_view to_string(Role role) noexcept;
/// Returns kNone for a word that is not known: a newer robot may have roles that nobody here reads.
[[nodiscard]] Role role_named(std::string_view word) noexcept;

/// Throws std::logic_error, which names component and attribute, if a role stands on an attribute
/// of another type than it needs, or `of` names no attribute that could be meant.
void require_sound_roles(const ComponentSpec& component);

/// Returns the pictures that schemas of the catalog make, besides the camera's own, in its order.
[[nodiscard]] std::vector<std::string> picture_channels(const Catalog& catalog);

}  // namespace galilean
