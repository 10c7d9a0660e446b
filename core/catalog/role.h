// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace galilean {

struct Catalog;
struct ComponentSpec;

/// What an attribute means to code that knows no component by name: to viewers, the map and the
/// simulator. Below, `of` is AttributeSpec::of.
enum class Role {
  kNone,
  kGain,              ///< number or numbers: the factors of the forces that `of` names
  kChannel,           ///< written image: viewers get it as the picture `of`
  kSighting,          ///< written locate: what was found in the image `of`
  kThreshold,         ///< number: the brightness from which a pixel of the image `of` stands out
  kPolarity,          ///< choice, bright or dark: with dark, pixels below the threshold stand out
  kLeastArea,         ///< number: a group of fewer touching pixels is no object in the image `of`
  kCertaintyAtLeast,  ///< number: the bit is 1 while the certainty of the locate `of` is at least
                      ///< this
  kCertaintyBelow,    ///< number: the bit is 1 while the certainty of the locate `of` is below this
  kDistanceAtMost,    ///< number: the bit is 1 while the locate `of` is at most this far away
  kTimeAtLeast,       ///< number: the bit is 1 once the state has lasted this long
  kBumper,            ///< index of a bit: the bumper that the bit shows; less than 0: all bumpers
  kGripperBeam,       ///< index of a bit: 1 while something stands in the gripper's beam
  kGripperCommand,    ///< choice, open or close: the command to the gripper
  kCameraHeight,      ///< number: the height of the lens over the floor
  kCameraForward      ///< number: how far the lens is in front of the robot's centre
};
/// Returns the word for the role in the catalog's JSON.
[[nodiscard]] std::string_view to_string(Role role) noexcept;
/// Returns kNone for an unknown word: a newer robot may have roles that this program does not know.
[[nodiscard]] Role role_named(std::string_view word) noexcept;

/// Errors: throws std::logic_error, which names component and attribute, if an attribute cannot
/// have its role. Either it has the wrong type, or its `of` names no suitable attribute.
void require_sound_roles(const ComponentSpec& component);

/// Returns the names of the pictures that schemas of the catalog make, in the catalog's order. The
/// camera's own picture is not among them.
[[nodiscard]] std::vector<std::string> picture_channels(const Catalog& catalog);

}  // namespace galilean
