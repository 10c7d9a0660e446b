// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/robot/perceptual/perspective.h"
#include "tests/robot/schema_test.h"

namespace galilean::robot {

using namespace std::string_literals;

inline constexpr Colour kRed{200, 40, 40};
inline constexpr Colour kGreen{30, 170, 50};
inline constexpr Colour kBlue{40, 60, 170};
inline constexpr Colour kDarkBlue{14, 18, 44};
inline constexpr Colour kBlack{18, 18, 20};

/// Tests of a robot that stands in the odom frame's origin and faces along y, so that its frame is
/// the global one.
class VisionTest : public SchemaTest {
 protected:
  VisionTest() {
    for (const char* name : {"red", "green", "blue", "dark"})
      variable<Image>(name).constant = false;
    look_ = make("look", {{"red_variable", "red"s},
                          {"green_variable", "green"s},
                          {"blue_variable", "blue"s},
                          {"dark_variable", "dark"s}});
  }
  std::unique_ptr<Schema> detector(std::map<std::string, Value> given) {
    given.insert({"shaft_variable", "shaft"s});
    given.insert({"image_variable", "red"s});
    given.insert({"locate_variable", "target"s});
    return make("blob_detector", std::move(given));
  }
  Variable<Locate>& target() { return variable<Locate>("target"); }
  /// Makes the target unknown again, with the radius `radius_m`.
  void forget_target(double radius_m) {
    target() = {.name = "target", .constant = false};
    target().value.radius_m = radius_m;
  }
  /// Takes a new picture, finds its blobs and runs the detector on it.
  void show(const Perspective& scene, Schema& detector) {
    advance(0.1);
    scene.draw(frame_grabber.camera, frame_grabber.picture);
    ++frame_grabber.picture.number;
    frame_grabber.picture.captured = tick.now;
    shaft().mark_written(1, tick.now, tick.number);
    look_->run(tick);
    detector.run(tick);
  }
  static Cylinder can(Vec2 centre_m) { return {centre_m, 0.033, 0.12, kRed}; }
  static Cylinder basket(Vec2 centre_m) { return {centre_m, 0.15, 0.35, kBlack}; }

  std::unique_ptr<Schema> look_;
};

}  // namespace galilean::robot
