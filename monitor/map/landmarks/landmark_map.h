// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/wire/messages.h"
#include "monitor/map/landmarks/basket_recognition.h"
#include "monitor/map/landmarks/data_association.h"
#include "monitor/map/landmarks/landmark_contacts.h"
#include "monitor/map/landmarks/landmark_publication.h"
#include "monitor/map/landmarks/landmark_store.h"
#include "monitor/map/landmarks/negative_information.h"
#include "monitor/map/landmarks/viewpoint.h"

namespace galilean::monitor {

/// The landmarks of a joint distribution, estimated together with the robots that saw them. This is
/// landmark SLAM with an extended Kalman filter.
///
///   reads   Sightings of robots whose pose was predicted up to the frame
///   law     Each observation is associated with a landmark or starts a new one (DataAssociation).
///   A
///           sure match corrects landmark and robot. Trash that lies elsewhere than predicted was
///           moved: it is relocated and corrects no robot. Baskets stay, and stand apart
///           (BasketRecognition). What should have been seen and was not loses its certainty
///           (NegativeInformation)
///   source  Smith, Self, Cheeseman 1990; Thrun, Burgard, Fox 2005, chapter 10
class LandmarkMap {
 public:
  LandmarkMap(JointGaussian& joint, const RobotPoses& robots, LandmarkIds& ids)
      : joint_(joint), robots_(robots), store_(joint, robots, ids) {}

  /// Takes in a frame of a robot of this joint distribution. Returns from where it looked.
  Viewpoint update(const msg::Sightings& frame, Time now);
  /// Takes in a frame from a robot of another group: lowers the certainty of landmarks that it
  /// should have seen and did not. Looks no further than kVisibleTo_m.
  void penalize_unseen(const msg::Sightings& frame, const Viewpoint& from) {
    negative_information_.penalize_unseen(frame, from);
  }
  /// See LandmarkContacts.
  void add_contact(const std::string& object_class, const std::string& robot,
                   const Gaussian2& in_robot, double certainty, Time now, std::uint64_t id = 0) {
    contacts_.add_contact(object_class, robot, in_robot, certainty, now, id);
  }
  void inflate_near(const std::string& robot, double for_s) {
    contacts_.inflate_near(robot, for_s);
  }
  void clear_footprint(const std::string& robot) { contacts_.clear_footprint(robot); }
  void clear_footprint(const Gaussian2& robot) { contacts_.clear_footprint(robot); }

  /// Lets certainties decay, and removes what expired.
  void decay(Time now) { store_.decay(now); }
  void remove(std::uint64_t id) { store_.remove(id); }
  /// Removes what only `robot` saw, and not for long: it was not where it was believed to be.
  void discard_recent(const std::string& robot, Time now);
  /// Makes one landmark of two that are the same object, and corrects all that depends on either.
  void merge(std::uint64_t kept, std::uint64_t duplicate) { store_.merge(kept, duplicate); }

  [[nodiscard]] const std::vector<Landmark>& all() const noexcept { return store_.all(); }
  /// Returns the landmark's position in the map frame.
  [[nodiscard]] Gaussian2 position(const Landmark& landmark) const {
    return store_.position(landmark);
  }
  /// Returns the bounding box of all landmarks in the map frame [m].
  [[nodiscard]] Eigen::AlignedBox2d extent_m() const { return store_.extent_m(); }
  /// See landmark_publication.h.
  [[nodiscard]] bool is_duplicate_candidate(const Landmark& landmark) const {
    return monitor::is_duplicate_candidate(joint_, store_, landmark);
  }
  [[nodiscard]] bool is_published(const Landmark& landmark) const {
    return monitor::is_published(joint_, store_, landmark);
  }

 private:
  void associate(const std::string& robot, std::vector<Observation>& observations, Time now);
  void take_in(const DataAssociation::Match& match, const std::string& robot,
               const Measurement& measurement, Time now);
  [[nodiscard]] bool is_informative(const Landmark& landmark, const std::string& robot,
                                    Time now) const;

  JointGaussian& joint_;
  const RobotPoses& robots_;
  LandmarkStore store_;
  DataAssociation association_{joint_, robots_, store_};
  BasketRecognition baskets_{joint_, robots_, store_};
  NegativeInformation negative_information_{joint_, robots_, store_};
  LandmarkContacts contacts_{joint_, robots_, store_};
};

}  // namespace galilean::monitor
