#pragma once

#include <map>
#include <optional>
#include <string>

#include "monitor/map/landmarks/landmark_map.h"
#include "monitor/map/relocalization/lost_robots.h"
#include "monitor/map/relocalization/rigid_fit.h"

namespace galilean::monitor {

/// Finds out which landmarks were noted twice, by two robots that did not know well enough where
/// they are, or by one that lost its way; and so where those robots are.
///
///   law     two landmarks of a class near one another are one where their places are known well
///   and
///           nothing else comes into question. Where they are not, the landmarks of a robot and
///           those of the others are matched by the rigid transformation that most of them agree
///           on. Where a robot shares nothing with the others, because it is not where it was said
///           to be, all pairs of a class are tried; a transformation that at least kLeastForUnknown
///           agree on, twice running, moves the robot and what it alone saw. One that lost its way
///           is laid back (LostRobots).
///   source  mrpt::tfest
class SameThings {
 public:
  static constexpr std::size_t kLeastAgreeing = 5;
  static constexpr std::size_t kLeastForUnknown = 8;

  SameThings(JointGaussian& joint, RobotPoses& robots, LandmarkMap& landmarks)
      : joint_(joint), robots_(robots), landmarks_(landmarks) {}

  void merge_neighbours();
  /// Of one robot, another one with each call. `others_know`: landmarks that robots saw which are
  /// not of the joint distribution.
  void align(Time now, const std::vector<Mark>& others_know);

 private:
  struct Pair {
    std::uint64_t kept, same;
    double squared_distance;
  };

  [[nodiscard]] std::optional<Pair> nearest_neighbours() const;
  void merge_agreeing(const std::string& robot);
  [[nodiscard]] bool shares_landmarks(const std::string& robot) const;
  void search(const std::string& robot);
  [[nodiscard]] std::vector<JointGaussian::Part> robot_and_seen_alone(
      const std::string& robot) const;
  [[nodiscard]] std::vector<PointPair> pairs(const std::string& robot, bool inside_gate) const;

  JointGaussian& joint_;
  RobotPoses& robots_;
  LandmarkMap& landmarks_;
  LostRobots lost_{joint_, robots_, landmarks_};
  Time now_{};
  std::map<std::string, RigidFit> candidates_;  ///< found once
  std::string last_aligned_;
};

}  // namespace galilean::monitor
