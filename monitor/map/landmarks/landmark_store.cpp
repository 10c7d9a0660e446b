// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/landmarks/landmark_store.h"

#include <algorithm>

#include "monitor/map/estimation/measurement_model.h"

namespace galilean::monitor {
namespace {

/// Standard deviation of the measurement that two landmarks of one object have one position.
constexpr double kSamePosition_m = 0.02;

}  // namespace

void LandmarkStore::add(const std::string& object_class, const std::string& robot,
                        const Gaussian2& in_robot, double certainty, Time now, std::uint64_t id) {
  make_room();
  const auto inverse = inverse_measurement(joint_, robots_.block(robot), in_robot);
  Landmark& landmark = landmarks_.emplace_back();
  landmark.id = id ? id : ids_.next();
  landmark.object_class = object_class;
  landmark.block = joint_.add(inverse.in_map_m, inverse.terms, inverse.noise_m2);
  landmark.certainty = certainty;
  landmark.sightings = id ? Landmark::kConfirmingSightings : 1;
  landmark.first_seen = landmark.decayed_until = landmark.last_seen = landmark.seen_by[robot] = now;
}

void LandmarkStore::relocate(Landmark& landmark, const std::string& robot,
                             const Gaussian2& in_robot) {
  const auto inverse = inverse_measurement(joint_, robots_.block(robot), in_robot);
  joint_.remove(landmark.block);
  landmark.block = joint_.add(inverse.in_map_m, inverse.terms, inverse.noise_m2);
}

void LandmarkStore::decay(Time now) {
  for (auto& landmark : landmarks_) landmark.decay(now);
  remove_if([&](const Landmark& landmark) { return landmark.is_expired(now); });
}

void LandmarkStore::remove(std::uint64_t id) {
  remove_if([&](const Landmark& landmark) { return landmark.id == id; });
}

void LandmarkStore::remove_if(const std::function<bool(const Landmark&)>& matches) {
  std::erase_if(landmarks_, [&](const Landmark& landmark) {
    const bool removed = matches(landmark);
    if (removed) joint_.remove(landmark.block);
    return removed;
  });
}

void LandmarkStore::merge(std::uint64_t kept, std::uint64_t duplicate) {
  Landmark* landmark = find(kept);
  const Landmark* other = find(duplicate);
  if (!landmark || !other || landmark == other) return;
  const JointGaussian::Term difference[] = {{other->block, Mat2::Identity()},
                                            {landmark->block, -Mat2::Identity()}};
  joint_.correct(difference, joint_.position(landmark->block) - joint_.position(other->block),
                 kSamePosition_m * kSamePosition_m * Mat2::Identity());
  landmark->merge(*other);
  remove(duplicate);
}

Gaussian2 LandmarkStore::position(const Landmark& landmark) const {
  return {joint_.position(landmark.block), joint_.covariance(landmark.block)};
}

Eigen::AlignedBox2d LandmarkStore::extent_m() const {
  Eigen::AlignedBox2d box;
  for (const auto& landmark : landmarks_) box.extend(joint_.position(landmark.block));
  return box;
}

Landmark* LandmarkStore::find(std::uint64_t id) {
  const auto found = std::ranges::find(landmarks_, id, &Landmark::id);
  return found == landmarks_.end() ? nullptr : &*found;
}

void LandmarkStore::make_room() {
  if (landmarks_.size() < kMaxLandmarks) return;
  remove(std::ranges::min_element(landmarks_, {}, &Landmark::certainty)->id);
}

}  // namespace galilean::monitor
