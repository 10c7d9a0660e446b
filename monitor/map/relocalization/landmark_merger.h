// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>

#include "monitor/map/landmarks/landmark_map.h"
#include "monitor/map/relocalization/relocalizer.h"
#include "monitor/map/relocalization/rigid_fit.h"

namespace galilean::monitor {

/// Finds landmarks that are duplicates of one object and merges them. Duplicates come from two
/// robots that did not know well enough where they are, or from one that lost its way. Merging them
/// corrects those robots.
///
///   law     Two landmarks of a class near one another are merged if their positions are known well
///           and inside the gate. Where they are not known well, the landmarks of a robot are
///           matched with those of the others by the rigid transformation that most of them agree
///           on. A robot that shares no landmark with the others may be somewhere else: all pairs
///           of a class are tried, and a transformation on which at least kLeastForUnknown agree,
///           twice in a row, moves the robot and what it alone saw. A robot that lost its way is
///           put back by the Relocalizer
///   source  mrpt::tfest
class LandmarkMerger {
 public:
  static constexpr std::size_t kLeastAgreeing = 5;
  static constexpr std::size_t kLeastForUnknown = 8;

  LandmarkMerger(JointGaussian& joint, RobotPoses& robots, LandmarkMap& landmarks)
      : joint_(joint), robots_(robots), landmarks_(landmarks) {}

  void merge_neighbours();
  /// Aligns one robot, another one with each call. `known_to_others` are landmarks of other groups,
  /// in the map frame.
  void align(Time now, const std::vector<LabelledPoint>& known_to_others);

 private:
  struct Pair {
    std::uint64_t kept, duplicate;
    double squared_distance;
  };

  [[nodiscard]] std::optional<Pair> nearest_neighbours() const;
  void merge_agreeing(const std::string& robot);
  [[nodiscard]] bool shares_landmarks(const std::string& robot) const;
  void align_unknown(const std::string& robot);
  [[nodiscard]] std::vector<JointGaussian::Block> robot_and_seen_alone(
      const std::string& robot) const;
  [[nodiscard]] std::vector<Correspondence> correspondences(const std::string& robot,
                                                            bool inside_gate) const;

  JointGaussian& joint_;
  RobotPoses& robots_;
  LandmarkMap& landmarks_;
  Relocalizer relocalizer_{joint_, robots_, landmarks_};
  Time now_{};
  std::map<std::string, RigidFit> candidates_;  ///< by robot: what was found once
  std::string last_aligned_;
};

}  // namespace galilean::monitor
