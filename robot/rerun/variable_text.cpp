// SPDX-License-Identifier: BSD-3-Clause
#include "robot/rerun/variable_text.h"

#include <cstdio>

#include "core/plural.h"
#include "core/visible_text.h"

namespace galilean::robot {
namespace {

std::string place(const Vec2& point) {
  return "x_m " + exact(point.x()) + ", y_m " + exact(point.y());
}

std::string text_of(const Shaft& shaft) {
  return place(shaft.pose.position_m) + ", heading_rad " + exact(shaft.pose.heading_rad) +
         ", speed_mps " + exact(shaft.speed_mps) + ", turn_rate_radps " +
         exact(shaft.turn_rate_radps);
}
std::string text_of(const Image& image) {
  return "of picture " + std::to_string(image.frame);
}
std::string text_of(const Locate& locate) {
  const Mat2& covariance = locate.covariance_m2;
  return place(locate.position_m) + ", variances " + exact(covariance(0, 0)) + ' ' +
         exact(covariance(0, 1)) + ' ' + exact(covariance(1, 1)) + " m², " +
         plural(locate.sightings.size(), "sighting") + " in picture " +
         std::to_string(locate.sightings_frame);
}
std::string text_of(const Bits& bits) {
  return std::to_string(bits.value);
}
std::string text_of(const Force& force) {
  return "x " + exact(force.value.x()) + ", y " + exact(force.value.y());
}

}  // namespace

std::string exact(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", number);
  return text;
}

std::string variable_text(const RunningProgram& program, std::size_t index) {
  std::string text;
  std::size_t at = 0;
  program.variables.for_each([&]<class T>(const Variable<T>& variable) {
    if (at++ != index) return;
    const Reliability& reliability = variable.reliability;
    text = std::string(variable_type_name<T>()) + " '" + visible(variable.name) +
           "': " + (reliability.valid ? "valid" : "invalid") + ", certainty " +
           exact(reliability.certainty) + " at " +
           exact(to_seconds(reliability.stamp.time_since_epoch())) + " s, " +
           text_of(variable.value);
  });
  return text;
}

std::string motion_text(const MotionOrders& orders) {
  if (orders.count == 0) return "nothing";
  const std::string count = " (" + plural(orders.count, "order") + ')';
  if (orders.stop) return "to stop" + count;
  return "speed_mps " + exact(orders.last.speed_mps) + ", turn_rate_radps " +
         exact(orders.last.turn_rate_radps) + ", distance_limit_m " +
         exact(orders.last.distance_limit_m) + ", angle_limit_rad " +
         exact(orders.last.angle_limit_rad) + count;
}

}  // namespace galilean::robot
