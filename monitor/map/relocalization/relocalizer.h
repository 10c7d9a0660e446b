// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "monitor/map/landmarks/landmark_map.h"
#include "monitor/map/relocalization/labelled_point.h"
#include "monitor/map/relocalization/rigid_fit.h"

namespace galilean::monitor {

/// Corrects the poses of robots that lost their way, by the known landmarks that they see again.
///
///   law   A robot that recognizes none of the older landmarks is corrected by LocalRigidFit. So is
///         a robot that associated its observations with the wrong landmarks: it adds all that it
///         sees beside the landmarks of the others, and localizes by its own. Landmarks that it
///         alone added move with it. The less certain its position is, the further away it is
///         searched for
class Relocalizer {
 public:
  Relocalizer(JointGaussian& joint, RobotPoses& robots, LandmarkMap& landmarks)
      : joint_(joint), robots_(robots), landmarks_(landmarks) {}

  /// Corrects `robot`'s pose if it lost its way. `known_to_others` are landmarks of other groups,
  /// in the map frame.
  void relocalize(const std::string& robot, Time now,
                  const std::vector<LabelledPoint>& known_to_others);

 private:
  [[nodiscard]] bool recognizes_nothing(const std::string& robot) const;
  /// Matches the landmarks that the robot added recently with all older ones.
  void relocalize_recent(const std::string& robot,
                         const std::vector<LabelledPoint>& known_to_others);
  /// Matches all landmarks that the robot saw lately with those that several robots saw.
  void rejoin(const std::string& robot, const std::vector<LabelledPoint>& known_to_others);
  [[nodiscard]] std::vector<const Landmark*> stable_landmarks() const;
  [[nodiscard]] LabelledPoint point_of(const Landmark& landmark) const;
  [[nodiscard]] std::optional<RigidFit> find(const std::string& robot,
                                             const std::vector<LabelledPoint>& seen,
                                             const std::vector<LabelledPoint>& known) const;
  [[nodiscard]] bool is_in_place(const std::string& robot, const RigidFit& fit) const;
  /// Transforms the robot and its own landmarks, and merges the landmarks that agree.
  void apply(const std::vector<JointGaussian::Block>& robot_and_own, const RigidFit& fit);

  JointGaussian& joint_;
  RobotPoses& robots_;
  LandmarkMap& landmarks_;
  Time now_{};
};

}  // namespace galilean::monitor
