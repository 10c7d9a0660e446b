#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/wire/messages.h"
#include "monitor/map/estimation/robot_poses.h"
#include "monitor/map/estimation/sighting_model.h"
#include "monitor/map/landmarks/landmark.h"

namespace galilean::monitor {

/// Counts the team's landmarks, so that none has the number of another.
class LandmarkIds {
 public:
  [[nodiscard]] std::uint64_t next() noexcept { return ++last_; }

 private:
  std::uint64_t last_ = 0;
};

/// From where a robot looked for how long, and saw all that was there.
struct Viewpoint {
  Pose2 pose;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of x, y [m] and heading [rad]
  double for_s = 0;                                      ///< 0: it may be anywhere
};

/// What stands on the floor, estimated together with the robots that saw it.
///
///   reads   Sightings, after the robot was moved to their pose
///   law     a sighting belongs to the landmark of its class that is nearest by Mahalanobis
///   distance
///           and inside the gate, each landmark to one sighting of a frame at most: what is seen as
///           two stays two. It corrects landmark and robot. Where two landmarks come into question
///           alike, it corrects neither, unless they may be one that was noted twice; where where
///           to look is not known well, it makes a new landmark, and SameThings finds out. Trash
///           that lies elsewhere than expected was moved, and corrects no robot; baskets stay, and
///           stand apart.
class LandmarkMap {
 public:
  static constexpr double kFootprint_m = 0.15;  ///< of its centre, wherever its nose points

  LandmarkMap(JointGaussian& joint, const RobotPoses& robots, LandmarkIds& ids)
      : joint_(joint), robots_(robots), ids_(ids) {}

  /// By a robot of the joint distribution.
  Viewpoint update(const msg::Sightings& frame, Time now);
  /// By one that is none of it: doubts what it misses in plain view, within kPlainViewTo_m.
  void penalize_unseen(const msg::Sightings& frame, const Viewpoint& from);
  /// Something that a robot touched or put down, `from_robot` of its centre. What is touched again
  /// is the same, and tells nothing of where the robot is.
  void add_contact(const std::string& object_class, const std::string& robot,
                   const Gaussian2& from_robot, double certainty, Time now, std::uint64_t id = 0);
  /// Lets certainties fade and forgets what reached 0.
  void decay(Time now);
  void remove(std::uint64_t id);
  /// What a robot noted lately, and nobody else: it was not where it believed to be.
  void discard_recent(const std::string& robot, Time now);
  /// `same` is `kept`, noted twice: corrects all that hangs on either.
  void merge(std::uint64_t kept, std::uint64_t same);
  /// What stands so near to a moving robot may be pushed by it.
  void inflate_near(const std::string& robot, double for_s);
  /// No piece of trash lies where a robot stands: it was pushed away, or picked up.
  void clear_footprint(const std::string& robot);
  /// Likewise where one stands that is not of the joint distribution, within kFootprint_m.
  void clear_footprint(const Gaussian2& robot);

  /// The box around all of them.
  [[nodiscard]] Eigen::AlignedBox2d extent_m() const;
  [[nodiscard]] const std::vector<Landmark>& all() const noexcept { return landmarks_; }
  [[nodiscard]] Gaussian2 place(const Landmark& landmark) const;
  /// Another one, whose place is known better, may be the same.
  [[nodiscard]] bool is_duplicate_candidate(const Landmark& landmark) const;
  /// It is to be told.
  [[nodiscard]] bool is_published(const Landmark& landmark) const;

 private:
  struct Seen {
    const msg::Sighting* sighting;
    Bearing bearing;
    std::optional<std::size_t> landmark;  ///< that it belongs to
  };
  struct Match {
    double squared_distance;
    std::size_t seen, landmark;
    bool is_sure = false;  ///< nothing else comes into question
  };
  static constexpr std::size_t kMaxLandmarks = 160;

  /// The surest among what is not matched yet.
  [[nodiscard]] std::optional<Match> match(const std::vector<Seen>& seen,
                                           const std::string& observer) const;
  /// How unsure the place may be where to look for it.
  [[nodiscard]] double max_deviation_m(const Landmark& landmark, const std::string& robot) const;
  [[nodiscard]] bool is_informative(const Landmark& landmark, const std::string& robot,
                                    Time now) const;
  /// It lies where this robot sees it now, wherever it was: it tells nothing of the robot.
  void replace(Landmark& landmark, const std::string& robot, const Gaussian2& from_robot);
  void correct(const Landmark& landmark, const Bearing& bearing, JointGaussian::Part robot);
  void note_recognition(const msg::Sightings& frame, const std::vector<Seen>& seen, Time now);
  /// A basket where none is known, but beside one that is, or nearest to one where the robot is
  /// lost: it is that one, and the robot is elsewhere than it is believed to be.
  void recognise_baskets(const std::string& robot, std::vector<Seen>& seen);
  [[nodiscard]] std::optional<std::size_t> basket_beside(const Seen& basket,
                                                         const std::string& robot) const;
  void relocate(const std::string& robot, const Landmark& basket, const Bearing& bearing);
  /// For how long it is to be relied upon what a robot sees and misses [s].
  double looked_s(const std::string& robot, Time now);
  void penalize_unseen(const msg::Sightings& frame, const std::vector<Seen>& seen, double for_s);
  void make_room();
  Landmark* find(std::uint64_t id);

  JointGaussian& joint_;
  const RobotPoses& robots_;
  LandmarkIds& ids_;
  std::vector<Landmark> landmarks_;
  std::map<std::string, Time> last_frame_;
  std::map<std::string, Time> oriented_;       ///< when a robot saw last what it can go by
  std::map<std::string, int> strange_frames_;  ///< running, in which a robot saw such a basket
  std::set<std::string> among_others_;         ///< robots that saw what another one saw
};

}  // namespace galilean::monitor
