// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/wire/messages.h"
#include "monitor/map/landmarks/data_association.h"
#include "monitor/map/landmarks/viewpoint.h"

namespace galilean::monitor {

/// Penalizes landmarks that a camera should see and does not (negative information). A landmark is
/// penalized for as long as its position is in the camera's visible area and nothing is seen there.
/// That counts only while the robot recognizes landmarks, and only if the landmark's position and
/// the robot's pose are known well.
class NegativeInformation {
 public:
  NegativeInformation(const JointGaussian& joint, const RobotPoses& robots,
                      LandmarkStore& landmarks)
      : joint_(joint), robots_(robots), landmarks_(landmarks) {}

  /// Takes in which landmarks a robot recognizes in a frame. Returns how long it looked since its
  /// frame before [s]; 0 if it recognized none lately, because its pose may then be wrong.
  double looked_s(const std::string& robot, const std::vector<Observation>& observations, Time now);
  /// Penalizes landmarks that a robot of this map should have seen for `for_s` and did not.
  void penalize_unseen(const msg::Sightings& frame, const std::vector<Observation>& observations,
                       double for_s);
  /// Does the same for a frame from a robot of another group, which looked from `from`.
  void penalize_unseen(const msg::Sightings& frame, const Viewpoint& from);

 private:
  const JointGaussian& joint_;
  const RobotPoses& robots_;
  LandmarkStore& landmarks_;
  std::map<std::string, Time> last_frame_;  ///< by robot
  /// By robot: when it last recognized a landmark.
  std::map<std::string, Time> recognized_;
};

}  // namespace galilean::monitor
