// SPDX-License-Identifier: BSD-3-Clause
#include "robot/variables/settings.h"

namespace galilean::robot {
namespace {

template <class T>
void describe_reliability(Declaration<T>& is) {
  is.choice(static_cast<bool T::*>(&T::valid), "status", {"invalid", "valid"}, "invalid",
            "whether the content may be used from the start");
  is.number(static_cast<double T::*>(&T::certainty), "certainty", unit::kNone, 1,
            "from 0 (not reliable) to 1 (most reliable), while the status is valid")
      .range(0, 1);
  is.number(static_cast<double T::*>(&T::memory_s), "memory", unit::kSecond, 60,
            "time in which certainty falls from 1 to 0 after a schema last wrote it; 0: never. A "
            "variable that no schema writes does not fade")
      .range(0, 86400);
}

}  // namespace

Reliability ReliabilitySettings::reliability() const noexcept {
  Reliability result;
  result.valid = valid;
  result.certainty = certainty;
  result.decay_per_s = memory_s > 0 ? 1 / memory_s : 0;
  return result;
}

void ShaftSettings::describe(Declaration<ShaftSettings>& is) {
  is.help("Where the robot is and which way it faces, by dead reckoning on both motor shafts.");
  is.pair(&ShaftSettings::position_m, "position", unit::kCentimetre, {0, 0},
          "where it starts, in the robot's global frame");
  is.number(&ShaftSettings::heading_rad, "heading", unit::kDegree, 0,
            "which way it faces at the start, counter-clockwise from the frame's x axis")
      .range(-360, 360);
  describe_reliability(is);
}

Shaft ShaftSettings::content() const noexcept {
  return {.pose = {position_m, wrap_angle(heading_rad)}};
}

void ImageSettings::describe(Declaration<ImageSettings>& is) {
  is.help("One 8-bit component of the newest camera picture, 352 by 186 pixels.");
  describe_reliability(is);
}

void LocateSettings::describe(Declaration<LocateSettings>& is) {
  is.help("Where an object of the environment is, in the robot's global frame.");
  is.choice(&LocateSettings::object, "class", {"unknown", "trash", "basket", "obstacle", "robot"},
            "unknown", "what kind of object it is");
  is.pair(&LocateSettings::position_m, "position", unit::kCentimetre, {0, 0},
          "its centre, until a schema writes it");
  is.number(&LocateSettings::radius_m, "radius", unit::kCentimetre, 0,
            "of the object: from the front that the camera sees to its centre")
      .range(0, 1000);
  describe_reliability(is);
}

Locate LocateSettings::content() const noexcept {
  Locate result;
  result.object = object;
  result.position_m = position_m;
  result.radius_m = radius_m;
  return result;
}

void BitsSettings::describe(Declaration<BitsSettings>& is) {
  is.help("Binary events: gripper closed, bumper pressed, trash seen. Up to 32, bit 0 first.");
  is.number(&BitsSettings::value, "value", unit::kNone, 0, "the bits as one number")
      .range(0, 4294967295.0);
  describe_reliability(is);
}

Bits BitsSettings::content() const noexcept {
  return {value};
}

void ForceSettings::describe(Declaration<ForceSettings>& is) {
  is.help("A motor schema's vector in the robot's frame: x to the right, y forward.");
  is.pair(&ForceSettings::value, "value", unit::kNone, {0, 0},
          "until a schema writes it; one that none writes is a constant");
  describe_reliability(is);
}

Force ForceSettings::content() const noexcept {
  return {value};
}

}  // namespace galilean::robot
