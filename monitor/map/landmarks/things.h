#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/wire/messages.h"
#include "monitor/map/estimation/robot_poses.h"
#include "monitor/map/estimation/sighting_model.h"
#include "monitor/map/landmarks/thing.h"

namespace galilean::monitor {

/// Counts the team's things, so that none has the number of another.
class ThingIds {
 public:
  [[nodiscard]] std::uint64_t next() noexcept { return ++last_; }

 private:
  std::uint64_t last_ = 0;
};

/// From where a robot looked for how long, and saw all that was there.
struct Lookout {
  Pose2 pose;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of x, y [m] and heading [rad]
  double for_s = 0;                                      ///< 0: it may be anywhere
};

/// What stands on the floor, estimated together with the robots that saw it.
///
///   reads   Sightings, after the robot was moved to their pose
///   law     a sighting belongs to the thing of its class that is nearest by Mahalanobis distance
///           and inside the gate, each thing to one sighting of a frame at most: what is seen as
///           two stays two. It corrects thing and robot. Where two things come into question alike,
///           it corrects neither, unless they may be one that was noted twice; where where to look
///           is not known well, it makes a new thing, and SameThings finds out. Trash that lies
///           elsewhere than expected was moved, and corrects no robot; baskets stay, and stand
///           apart.
class Things {
 public:
  static constexpr double kFootprint_m = 0.15;  ///< of its centre, wherever its nose points

  Things(JointGaussian& joint, const RobotPoses& robots, ThingIds& ids)
      : joint_(joint), robots_(robots), ids_(ids) {}

  /// By a robot of the joint distribution.
  Lookout see(const msg::Sightings& frame, Time now);
  /// By one that is none of it: doubts what it misses in plain view, within kPlainViewTo_m.
  void miss(const msg::Sightings& frame, const Lookout& from);
  /// Something that a robot touched or put down, `from_robot` of its centre. What is touched again
  /// is the same, and tells nothing of where the robot is.
  void note(const std::string& object_class, const std::string& robot, const Gaussian2& from_robot,
            double certainty, Time now, std::uint64_t id = 0);
  /// Lets certainties fade and forgets what reached 0.
  void fade(Time now);
  void forget(std::uint64_t id);
  /// What a robot noted lately, and nobody else: it was not where it believed to be.
  void forget_new_of(const std::string& robot, Time now);
  /// `same` is `kept`, noted twice: corrects all that hangs on either.
  void unite(std::uint64_t kept, std::uint64_t same);
  /// What stands so near to a moving robot may be pushed by it.
  void blur_around(const std::string& robot, double for_s);
  /// No piece of trash lies where a robot stands: it was pushed away, or picked up.
  void clear_under(const std::string& robot);
  /// Likewise where one stands that is not of the joint distribution, within kFootprint_m.
  void clear_under(const Gaussian2& robot);

  /// The box around all of them.
  [[nodiscard]] Eigen::AlignedBox2d extent_m() const;
  [[nodiscard]] const std::vector<Thing>& all() const noexcept { return things_; }
  [[nodiscard]] Gaussian2 place(const Thing& thing) const;
  /// Another one, whose place is known better, may be the same.
  [[nodiscard]] bool may_be_told_twice(const Thing& thing) const;
  /// It is to be told.
  [[nodiscard]] bool tell(const Thing& thing) const;

 private:
  struct Seen {
    const msg::Sighting* sighting;
    Bearing bearing;
    std::optional<std::size_t> thing;  ///< that it belongs to
  };
  struct Match {
    double squared_distance;
    std::size_t seen, thing;
    bool is_sure = false;  ///< nothing else comes into question
  };
  static constexpr std::size_t kMostThings = 160;

  /// The surest among what is not matched yet.
  [[nodiscard]] std::optional<Match> match(const std::vector<Seen>& seen,
                                           const std::string& observer) const;
  /// How unsure the place may be where to look for it.
  [[nodiscard]] double most_deviation_m(const Thing& thing, const std::string& robot) const;
  [[nodiscard]] bool tells_anything(const Thing& thing, const std::string& robot, Time now) const;
  /// It lies where this robot sees it now, wherever it was: it tells nothing of the robot.
  void put(Thing& thing, const std::string& robot, const Gaussian2& from_robot);
  void correct(const Thing& thing, const Bearing& bearing, JointGaussian::Part robot);
  void note_orientation(const msg::Sightings& frame, const std::vector<Seen>& seen, Time now);
  /// A basket where none is known, but beside one that is, or nearest to one where the robot is
  /// lost: it is that one, and the robot is elsewhere than it is believed to be.
  void recognise_baskets(const std::string& robot, std::vector<Seen>& seen);
  [[nodiscard]] std::optional<std::size_t> basket_beside(const Seen& basket,
                                                         const std::string& robot) const;
  void relocate(const std::string& robot, const Thing& basket, const Bearing& bearing);
  /// For how long it is to be relied upon what a robot sees and misses [s].
  double looked_s(const std::string& robot, Time now);
  void doubt_unseen(const msg::Sightings& frame, const std::vector<Seen>& seen, double for_s);
  void make_room();
  Thing* find(std::uint64_t id);

  JointGaussian& joint_;
  const RobotPoses& robots_;
  ThingIds& ids_;
  std::vector<Thing> things_;
  std::map<std::string, Time> last_frame_;
  std::map<std::string, Time> oriented_;       ///< when a robot saw last what it can go by
  std::map<std::string, int> strange_frames_;  ///< running, in which a robot saw such a basket
  std::set<std::string> among_others_;         ///< robots that saw what another one saw
};

}  // namespace galilean::monitor
