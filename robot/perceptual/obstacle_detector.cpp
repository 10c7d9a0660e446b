// SPDX-License-Identifier: BSD-3-Clause
#include "robot/perceptual/obstacle_detector.h"

namespace galilean::robot {

void ObstacleDetector::describe(Declaration<ObstacleDetector>& is) {
  is.help("Remembers where the robot touched something.");
  is.reads(&ObstacleDetector::bits_, "bits_variable", "the bumpers");
  is.number(&ObstacleDetector::bit_index_, "bit_index", unit::kNone, 0, "which bumper")
      .range(0, 31);
  is.pair(
      &ObstacleDetector::translation_m_, "translation", unit::kCentimetre, {0, 22},
      "where the obstacle is when the bit is 1: to the right and forward of the robot's centre");
  is.reads(&ObstacleDetector::shaft_, "shaft_variable", "where the robot is")
      .default_value("shaft");
  is.writes(&ObstacleDetector::obstacle_, "obstacle_variable", "where the obstacle is");
}

void ObstacleDetector::run(const Tick& tick) {
  if (!bits_->valid_at(tick.now) || !bits_->value.test(bit_index_)) return;
  if (!shaft_->valid_at(tick.now)) return;
  Locate& obstacle = obstacle_->value;
  obstacle.position_m = point_to_global(shaft_->value.pose, translation_m_);
  obstacle.covariance_m2 = Mat2::Identity() * 0.01 * 0.01;
  obstacle_->mark_written(shaft_->certainty_at(tick.now), tick.now, tick.number);
}

}  // namespace galilean::robot
