#pragma once

#include <optional>
#include <string>
#include <vector>

#include "monitor/map/landmarks/landmark_map.h"
#include "monitor/map/relocalization/rigid_fit.h"
#include "monitor/map/relocalization/turned_robot.h"

namespace galilean::monitor {

/// Lays robots that lost their way back to where what they see was known to be.
///
///   law   a robot that recognises nothing of what was known is turned back as TurnedRobot says;
///         so is one that took its bearings from the wrong landmarks: it maps all it sees beside
///         what others know too, and goes by that. What it alone noted goes with it. It is looked
///         for further away the less it is known where it is
class LostRobots {
 public:
  LostRobots(JointGaussian& joint, RobotPoses& robots, LandmarkMap& landmarks)
      : joint_(joint), robots_(robots), landmarks_(landmarks) {}

  /// `others_know`: landmarks that robots saw which are not of the joint distribution.
  void lay_back(const std::string& robot, Time now, const std::vector<Mark>& others_know);

 private:
  [[nodiscard]] bool recognises_nothing(const std::string& robot) const;
  void turn_back(const std::string& robot, const std::vector<Mark>& others_know);
  void rejoin(const std::string& robot, const std::vector<Mark>& others_know);
  [[nodiscard]] std::vector<const Landmark*> landmarks() const;
  [[nodiscard]] Mark mark_of(const Landmark& landmark) const;
  /// What lays the robot, and what it saw, onto what is known.
  [[nodiscard]] std::optional<RigidFit> find(const std::string& robot,
                                             const std::vector<Mark>& seen,
                                             const std::vector<Mark>& known) const;
  [[nodiscard]] bool is_there(const std::string& robot, const RigidFit& fit) const;
  /// Onto the landmarks that they agree with.
  void lay(const std::vector<JointGaussian::Part>& robot_and_own, const RigidFit& fit);

  JointGaussian& joint_;
  RobotPoses& robots_;
  LandmarkMap& landmarks_;
  Time now_{};
};

}  // namespace galilean::monitor
