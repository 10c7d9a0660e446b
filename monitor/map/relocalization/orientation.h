#pragma once

#include <map>
#include <string>
#include <vector>

#include "monitor/map/landmarks/landmark_map.h"
#include "monitor/map/relocalization/turned_robot.h"

namespace galilean::monitor {

/// Turns a robot on the map that faces otherwise than it is believed to: its treads slipped, or it
/// was pushed. A frame that shows several known landmarks at once tells (BearingsFit), where each
/// by itself could be mistaken for its neighbour.
///
///   law     a turn that so many frames running agree on corrects the heading: few where the robot
///           is known to be unsure of it, more where it is not. There it must not leave more of
///           what is known unseen in plain view than the heading it replaces, and a large turn must
///           leave less: else the robot is rather at a place that is new to it, where a few
///           landmarks lie by chance as known ones do
class Orientation {
 public:
  Orientation(JointGaussian& joint, const RobotPoses& robots, LandmarkMap& landmarks)
      : joint_(joint), robots_(robots), landmarks_(landmarks) {}

  /// Before the frame's sightings are matched; the robot was moved to its pose.
  void look(const msg::Sightings& frame, Time now);

 private:
  struct Suspicion {
    double turn_rad = 0;
    int frames = 0;
  };

  /// Where landmarks stand that it did not note only just now, perhaps turned as it is.
  [[nodiscard]] std::vector<Mark> known_to(const std::string& robot, Time now) const;
  /// Running, this one counted.
  int frames_that_agree(const std::string& robot, double turn_rad);
  /// Judged by the known landmarks that are missed in plain view, as it is believed to face and if
  /// turned.
  [[nodiscard]] bool is_plausible(double turn_rad, const msg::Sightings& frame,
                                  const std::vector<Mark>& seen,
                                  const std::vector<Mark>& known) const;
  void turn(const std::string& robot, double by_rad, double deviation_rad, Time now);

  JointGaussian& joint_;
  const RobotPoses& robots_;
  LandmarkMap& landmarks_;
  std::map<std::string, Suspicion> suspicions_;
};

}  // namespace galilean::monitor
