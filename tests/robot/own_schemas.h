// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "core/catalog/registry.h"
#include "core/device/device_names.h"
#include "core/device/devices.h"
#include "core/device/frame_grabber.h"
#include "core/device/motor_drive.h"
#include "core/schema/schema.h"
#include "core/variable/variable.h"

namespace galilean::robot {

/// These schemas are in no file of the project. Only their roles tell other code what they mean.

/// Makes a picture of one brightness.
class Contours final : public PerceptualSchema {
 public:
  static constexpr std::uint8_t kBrightness = 77;

  static void describe(Declaration<Contours>& is) {
    is.help("Draws contours.");
    is.writes(&Contours::picture_, "drawn_on", "the contours").role(Role::kChannel, "contours");
    is.needs(kFrameGrabberName);
    is.uses_devices(&Contours::devices_);
  }
  void run(const Tick& tick) override {
    const Frame& frame = devices_->frame_grabber.frame();
    std::ranges::fill(picture_->value.pixels, kBrightness);
    picture_->value.frame = frame.number;
    picture_->value.captured = frame.captured;
    picture_->mark_written(1, tick.now, tick.number);
  }

 private:
  Variable<Image>* picture_ = nullptr;
  const Devices* devices_ = nullptr;
};

/// Finds what glows in a picture.
class Glow final : public PerceptualSchema {
 public:
  static void describe(Declaration<Glow>& is) {
    is.help("Finds what glows.");
    is.reads(&Glow::scene_, "scene", "where to look");
    is.updates(&Glow::found_, "found", "what glows").role(Role::kSighting, "scene");
    is.number(&Glow::glow_, "glow", unit::kNone, 90, "from which brightness on")
        .range(0, 255)
        .role(Role::kThreshold, "scene");
    is.number(&Glow::least_, "speck", unit::kSquarePixel, 4, "what is smaller is dust")
        .range(1, 1000)
        .role(Role::kLeastArea, "scene");
  }
  void run(const Tick& tick) override {
    if (scene_->value.pixels[0] >= glow_) found_->mark_written(1, tick.now, tick.number);
  }

 private:
  const Variable<Image>* scene_ = nullptr;
  Variable<Locate>* found_ = nullptr;
  double glow_ = 0;
  double least_ = 0;
};

/// Sets a bit while a target is within a limit.
class InReach final : public PerceptualSchema {
 public:
  static void describe(Declaration<InReach>& is) {
    is.help("Tells what the arm could reach.");
    is.reads(&InReach::target_, "target", "what to reach");
    is.reads(&InReach::odometer_, "odometer", "where the robot is");
    is.number(&InReach::arm_m_, "arm", unit::kMillimetre, 500, "how long the arm is")
        .range(0, 10000)
        .role(Role::kDistanceAtMost, "target");
    is.updates(&InReach::flags_, "flags", "holds the bit");
    is.number(&InReach::flag_, "flag", unit::kNone, 3, "which bit").range(0, 31).bit_of("flags");
  }
  void run(const Tick& tick) override {
    const Vec2 way = target_->value.position_m - odometer_->value.pose.position_m;
    Bits bits = flags_->value;
    bits.assign(flag_, target_->valid_at(tick.now) && way.norm() <= arm_m_);
    flags_->write(bits, 1, tick.now, tick.number);
  }

 private:
  const Variable<Locate>* target_ = nullptr;
  const Variable<Shaft>* odometer_ = nullptr;
  Variable<Bits>* flags_ = nullptr;
  double arm_m_ = 0;
  unsigned flag_ = 0;
};

/// Takes a list of gains and a single gain, and drives.
class Steer final : public MotorSchema {
 public:
  static void describe(Declaration<Steer>& is) {
    is.help("Steers by pulls, and by one that brakes.");
    is.reads_all(&Steer::pulls_, "pulls", "what pulls");
    is.numbers(&Steer::weights_, "weights", unit::kNone, {}, "how much each pull counts")
        .range(0, 100)
        .one_for_each("pulls")
        .role(Role::kGain, "pulls");
    is.reads(&Steer::brake_, "brake", "what brakes");
    is.number(&Steer::grip_, "grip", unit::kNone, 0.5, "how much the brake counts")
        .range(0, 100)
        .role(Role::kGain, "brake");
    is.writes(&Steer::way_, "way", "where to");
    is.drives(kMotorDriveName);
    is.needs(kMotorDriveName);
    is.uses_devices(&Steer::devices_);
  }
  void run(const Tick& tick) override {
    way_->write({grip_ * brake_->value.value}, 1, tick.now, tick.number);
    devices_->motor_drive.stop();
  }

 private:
  std::vector<const Variable<Force>*> pulls_;
  std::vector<double> weights_;
  const Variable<Force>* brake_ = nullptr;
  double grip_ = 0;
  Variable<Force>* way_ = nullptr;
  const Devices* devices_ = nullptr;
};

inline void add_own_schemas(Registry& registry) {
  registry.add_schema<Contours>("contours");
  registry.add_schema<Glow>("glow");
  registry.add_schema<InReach>("in_reach");
  registry.add_schema<Steer>("steer");
}

}  // namespace galilean::robot
