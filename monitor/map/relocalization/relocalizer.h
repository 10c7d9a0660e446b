// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "monitor/map/landmarks/landmark_map.h"
#include "monitor/map/relocalization/labelled_point.h"
#include "monitor/map/relocalization/rigid_fit.h"

namespace galilean::monitor {

/// Puts robots that lost their way back to where what they see was known to be.
///
///   law   A robot that recognizes nothing of what was known is put back by LocalRigidFit. So is a
///         robot that associated its observations with the wrong landmarks: it maps all it sees
///         beside what others know, and goes by that. Landmarks that it alone added move with it.
///         The less certain its position is, the further away it is looked for
class Relocalizer {
 public:
  Relocalizer(JointGaussian& joint, RobotPoses& robots, LandmarkMap& landmarks)
      : joint_(joint), robots_(robots), landmarks_(landmarks) {}

  /// `known_to_others` are landmarks of other groups, in the map frame.
  void relocalize(const std::string& robot, Time now,
                  const std::vector<LabelledPoint>& known_to_others);

 private:
  [[nodiscard]] bool recognizes_nothing(const std::string& robot) const;
  /// Lays what the robot added lately on all that is older.
  void relocalize_recent(const std::string& robot,
                         const std::vector<LabelledPoint>& known_to_others);
  /// Lays all that the robot saw lately on what several robots saw.
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
