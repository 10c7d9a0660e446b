// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/landmarks/landmark_map.h"

namespace galilean::monitor {
namespace {

/// A robot's heading counts as unknown above this standard deviation.
constexpr double kHeadingUnknown_rad = 0.12;

/// Above this squared Mahalanobis distance from its prediction, a piece of trash was more likely
/// pushed than that its observer's pose is wrong.
constexpr double kMovedDistance = 4;

bool is_landmark(const msg::Sighting& sighting) {
  return sighting.object_class != "robot" && sighting.object_class != "obstacle";
}

std::vector<Observation> observations_in(const msg::Sightings& frame) {
  std::vector<Observation> observations;
  for (const auto& sighting : frame.items)
    if (const auto measurement = measurement_of(sighting, frame);
        measurement && is_landmark(sighting))
      observations.push_back({&sighting, *measurement, std::nullopt});
  return observations;
}

}  // namespace

Viewpoint LandmarkMap::update(const msg::Sightings& frame, Time now) {
  auto observations = observations_in(frame);
  associate(frame.robot, observations, now);
  baskets_.recognize(frame.robot, observations);
  association_.note(observations, frame.robot);
  const double for_s = negative_information_.looked_s(frame.robot, observations, now);
  negative_information_.penalize_unseen(frame, observations, for_s);
  for (const auto& each : observations)
    if (!each.landmark && each.measurement.complete)
      store_.add(each.sighting->object_class, frame.robot, each.measurement.in_robot,
                 1 - Landmark::kDoubtFactor, now);
  const auto robot = robots_.block(frame.robot);
  return {robots_.pose(frame.robot), joint_.covariance(robot).topLeftCorner<3, 3>(), for_s};
}

// Matches are taken in one by one, because each correction makes the next prediction better.
void LandmarkMap::associate(const std::string& robot, std::vector<Observation>& observations,
                            Time now) {
  while (const auto match = association_.next(observations, robot, now)) {
    Observation& observation = observations[match->observation];
    observation.landmark = match->landmark;
    take_in(*match, robot, observation.measurement, now);
  }
}

void LandmarkMap::take_in(const DataAssociation::Match& match, const std::string& robot,
                          const Measurement& measurement, Time now) {
  Landmark& landmark = store_.all()[match.landmark];
  landmark.observe(robot, now);
  if (!measurement.complete) return;
  const bool moved = landmark.object_class == "trash" && match.squared_distance > kMovedDistance;
  if (moved)
    store_.relocate(landmark, robot, measurement.in_robot);
  else if (match.is_sure && match.is_supported && is_informative(landmark, robot, now))
    correct_by(joint_, predict_measurement(joint_, robots_.block(robot), landmark.block),
               measurement.in_robot);
}

// A landmark that a robot added while its heading was unknown has the error of that heading. A
// correction by it would make the filter certain without new information.
bool LandmarkMap::is_informative(const Landmark& landmark, const std::string& robot,
                                 Time now) const {
  const double heading_variance = joint_.covariance(robots_.block(robot))(2, 2);
  return heading_variance < kHeadingUnknown_rad * kHeadingUnknown_rad ||
         !landmark.is_recent_of(robot, now);
}

void LandmarkMap::discard_recent(const std::string& robot, Time now) {
  store_.remove_if([&](const Landmark& landmark) {
    return landmark.object_class != "obstacle" && landmark.is_recent_of(robot, now);
  });
}

}  // namespace galilean::monitor
