// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/wire/messages.h"
#include "monitor/map/landmarks/data_association.h"
#include "monitor/map/landmarks/viewpoint.h"

namespace galilean::monitor {

/// What it says that a camera sees nothing where a landmark should be (negative information): the
/// landmark is penalized for as long as its position is in the camera's visible area and empty.
/// That counts only while the robot recognizes landmarks, and where position and pose are known
/// well.
class NegativeInformation {
 public:
  NegativeInformation(const JointGaussian& joint, const RobotPoses& robots,
                      LandmarkStore& landmarks)
      : joint_(joint), robots_(robots), landmarks_(landmarks) {}

  /// Returns for how long a robot looked since its last frame [s]; 0 if it recognized nothing
  /// lately. Such a robot may be elsewhere than it is believed to be. Takes in what it recognizes
  /// in this frame.
  double looked_s(const std::string& robot, const std::vector<Observation>& observations, Time now);
  /// Penalizes landmarks that a robot of this map should have seen and did not, for `for_s`.
  void penalize_unseen(const msg::Sightings& frame, const std::vector<Observation>& observations,
                       double for_s);
  /// The same for a frame from a robot of another group, which looked from `from`.
  void penalize_unseen(const msg::Sightings& frame, const Viewpoint& from);

 private:
  const JointGaussian& joint_;
  const RobotPoses& robots_;
  LandmarkStore& landmarks_;
  std::map<std::string, Time> last_frame_;  ///< by robot
  /// By robot: when it last saw a landmark that it can find its way by.
  std::map<std::string, Time> recognized_;
};

}  // namespace galilean::monitor
