// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "monitor/map/landmarks/landmark_map.h"
#include "monitor/map/relocalization/labelled_point.h"

namespace galilean::monitor {

/// Corrects the heading of a robot that faces elsewhere than it is believed to, because its treads
/// slipped or it was pushed. Data association alone would mistake each landmark for its neighbour,
/// where a frame with several landmarks tells the turn (HeadingFit).
///
///   law     A turn on which enough frames in a row agree corrects the heading. If the filter is
///           uncertain enough for such a turn, few frames are enough. If it is not, more are
///           needed, and the turn must leave no more known landmarks unseen in the visible area
///           than the heading that it replaces; a large turn must leave fewer. Otherwise the robot
///           is more likely at a place that is new to it, where a few objects lie by chance as
///           known ones do
class HeadingRecovery {
 public:
  HeadingRecovery(JointGaussian& joint, const RobotPoses& robots, LandmarkMap& landmarks)
      : joint_(joint), robots_(robots), landmarks_(landmarks) {}

  /// Takes in a frame before LandmarkMap::update does. Requires: the robot's pose was predicted up
  /// to the frame.
  void update(const msg::Sightings& frame, Time now);

 private:
  struct Suspicion {
    double turn_rad = 0;
    int frames = 0;
  };

  /// Returns the known landmarks near the robot, in the map frame. Those that it added recently are
  /// left out, because it may have been turned when it saw them.
  [[nodiscard]] std::vector<LabelledPoint> known_to(const std::string& robot, Time now) const;
  /// Returns how many frames in a row agree on this turn, including the newest.
  int frames_that_agree(const std::string& robot, double turn_rad);
  /// Compares how many known landmarks are unseen in the visible area, before and after the turn.
  [[nodiscard]] bool is_plausible(double turn_rad, const msg::Sightings& frame,
                                  const std::vector<LabelledPoint>& seen,
                                  const std::vector<LabelledPoint>& known) const;
  void turn(const std::string& robot, double by_rad, double deviation_rad, Time now);

  JointGaussian& joint_;
  const RobotPoses& robots_;
  LandmarkMap& landmarks_;
  std::map<std::string, Suspicion> suspicions_;  ///< by robot
};

}  // namespace galilean::monitor
