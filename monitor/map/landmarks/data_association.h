// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "monitor/map/estimation/measurement_model.h"
#include "monitor/map/landmarks/landmark_store.h"

namespace galilean::monitor {

/// An object of a camera frame, and the landmark that it was associated with.
struct Observation {
  const msg::Sighting* sighting;
  Measurement measurement;
  std::optional<std::size_t> landmark;  ///< index into LandmarkStore::all()
};

/// Decides which landmark an observation is of.
///
///   law     An observation is associated with the landmark of its class that is nearest by
///           Mahalanobis distance and inside the gate. Each landmark is associated with at most one
///           observation of a frame, so that two objects seen at once stay two. A match is sure if
///           no other landmark and no other observation fits nearly as well; duplicates of one
///           object are no rivals. A landmark whose predicted measurement is too uncertain is
///           associated with nothing: the observation becomes a new landmark, and LandmarkMerger
///           finds out later. Trash whose prediction is uncertain may be another piece, however
///           near it is: such a match is supported if a second one in the frame is jointly
///           compatible with it
///   source  gated nearest neighbour (Bar-Shalom, Li, Kirubarajan 2001); joint compatibility
///           (Neira, Tardós 2001)
class DataAssociation {
 public:
  /// An association of an observation with a landmark.
  struct Match {
    double squared_distance;  ///< squared Mahalanobis distance
    std::size_t observation, landmark;
    double deviation_m = 0;  ///< standard deviation of the prediction along its longest axis
    bool is_sure = false;    ///< nothing else comes into question
    bool is_supported =
        false;  ///< it alone, or together with another one, tells where the robot is
  };

  DataAssociation(const JointGaussian& joint, const RobotPoses& robots,
                  const LandmarkStore& landmarks)
      : joint_(joint), robots_(robots), landmarks_(landmarks) {}

  /// Returns the surest match among observations and landmarks that have none yet: sure ones first,
  /// then the nearest. Nothing if none is left.
  [[nodiscard]] std::optional<Match> next(const std::vector<Observation>& observations,
                                          const std::string& observer, Time now) const;
  /// Takes in which landmarks a frame was associated with.
  void note(const std::vector<Observation>& observations, const std::string& observer);

 private:
  [[nodiscard]] std::vector<Match> matches(const std::vector<Observation>& observations,
                                           const std::string& observer) const;
  /// Returns whether a match may correct the observer. `all` are the matches that come into
  /// question.
  [[nodiscard]] bool is_supported(const Match& match, const std::vector<Match>& all,
                                  const std::vector<Observation>& observations,
                                  const std::string& observer, Time now) const;
  [[nodiscard]] bool may_be_duplicates(std::size_t a, std::size_t b) const;
  /// Returns how uncertain the prediction may be (standard deviation).
  [[nodiscard]] double max_deviation_m(const Landmark& landmark, const std::string& robot) const;

  const JointGaussian& joint_;
  const RobotPoses& robots_;
  const LandmarkStore& landmarks_;
  std::set<std::string> share_landmarks_;  ///< robots that saw a landmark of another robot
};

}  // namespace galilean::monitor
