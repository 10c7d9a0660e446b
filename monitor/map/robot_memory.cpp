#include "monitor/map/robot_memory.h"

#include <algorithm>
#include <cmath>

namespace galilean::monitor {
namespace {

/// Two things of a class cannot stand nearer to one another than this.
double smallest_distance_m(const std::string& object_class) {
  if (object_class == "basket") return 0.30;
  return object_class == "obstacle" ? 0.20 : 0.06;
}

/// What dead reckoning adds while a landmark is not seen: (3 cm)² a second.
constexpr double kDrift_m2ps = 9e-4;
/// Of every sighting beside its own covariance: the robot's pose is not exact either. A part grows
/// with the range, as its heading's error does.
constexpr double kPoseError_m2 = 1.6e-3;
constexpr double kHeadingError_rad = 0.03;
/// Sightings that follow one another err alike: what each adds to what it takes away, so that a
/// place is never known better than to some centimetres.
constexpr double kCommonError_m2 = 1e-3;
constexpr double kTouchVariance_m2 = 2.5e-3;

/// What a camera must see if it is there: not so near that the blob leaves the picture, not so far
/// that it is small, and not at the picture's edge.
constexpr double kPlainViewFrom_m = 0.5;
constexpr double kPlainViewTo_m = 2.0;
constexpr double kPictureEdge_rad = 0.10;
constexpr double kHides_rad = 0.15;

Gaussian2 place_of(const msg::Sighting& sighting) {
  Gaussian2 place;
  place.mean_m = {sighting.x_m, sighting.y_m};
  place.covariance_m2 << sighting.variance_xx, sighting.variance_xy, sighting.variance_xy,
      sighting.variance_yy;
  const double across_m = kHeadingError_rad * sighting.range_m;
  place.covariance_m2 += (kPoseError_m2 + across_m * across_m) * Mat2::Identity();
  return place;
}

bool is_usable(const msg::Sighting& sighting) {
  const bool finite = std::isfinite(sighting.x_m) && std::isfinite(sighting.y_m) &&
                      std::isfinite(sighting.variance_xx) && std::isfinite(sighting.variance_xy) &&
                      std::isfinite(sighting.variance_yy);
  const double determinant =
      sighting.variance_xx * sighting.variance_yy - sighting.variance_xy * sighting.variance_xy;
  return finite && sighting.variance_xx >= 0 && sighting.variance_yy >= 0 && determinant >= 0 &&
         sighting.object_class != "robot" && !sighting.object_class.empty();
}

bool hides(const msg::Sightings& frame, double azimuth_rad, double range_m) {
  return std::ranges::any_of(frame.items, [&](const auto& other) {
    return other.range_m < range_m &&
           std::abs(wrap_angle(other.azimuth_rad - azimuth_rad)) < kHides_rad;
  });
}

}  // namespace

struct RobotMemory::Match {
  double squared_distance;
  std::size_t sighting;
  std::size_t landmark;
};

std::vector<RobotMemory::Match> RobotMemory::matches(const msg::Sightings& frame) const {
  std::vector<Match> found;
  for (std::size_t i = 0; i < frame.items.size(); ++i) {
    if (!is_usable(frame.items[i])) continue;
    const auto place = place_of(frame.items[i]);
    for (std::size_t j = 0; j < landmarks_.size(); ++j) {
      const Landmark& landmark = landmarks_[j];
      if (landmark.object_class != frame.items[i].object_class) continue;
      const double distance = squared_mahalanobis(place, landmark.place);
      const bool overlap = (place.mean_m - landmark.place.mean_m).norm() <
                           smallest_distance_m(landmark.object_class);
      if (distance < same_thing_gate() || overlap) found.push_back({distance, i, j});
    }
  }
  std::ranges::sort(found, {}, &Match::squared_distance);
  return found;
}

void RobotMemory::see(const msg::Sightings& frame, Time now) {
  fade(now);
  std::vector<bool> told(frame.items.size()), seen(landmarks_.size());
  for (const auto& [distance, i, j] : matches(frame)) {
    if (told[i] || seen[j]) continue;
    told[i] = seen[j] = true;
    confirm(landmarks_[j], place_of(frame.items[i]), now);
  }
  for (std::size_t i = 0; i < frame.items.size(); ++i)
    if (!told[i] && is_usable(frame.items[i]))
      learn(frame.items[i].object_class, place_of(frame.items[i]), now);
}

void RobotMemory::confirm(Landmark& landmark, const Gaussian2& sighting, Time now) {
  landmark.place.covariance_m2 +=
      kDrift_m2ps * to_seconds(now - landmark.last_seen) * Mat2::Identity();
  landmark.place = fused(landmark.place, sighting);
  landmark.place.covariance_m2 += kCommonError_m2 * Mat2::Identity();
  landmark.certainty = 1 - (1 - landmark.certainty) * kDoubtKept;
  landmark.last_seen = now;
}

void RobotMemory::learn(const std::string& object_class, const Gaussian2& sighting, Time now) {
  const bool overlaps = std::ranges::any_of(landmarks_, [&](const Landmark& other) {
    return other.object_class == object_class &&
           (other.place.mean_m - sighting.mean_m).norm() < smallest_distance_m(object_class);
  });
  if (!overlaps) landmarks_.push_back({object_class, sighting, 1 - kDoubtKept, now, now});
}

void RobotMemory::doubt_unseen(const msg::Sightings& frame, double period_s) {
  std::vector<bool> seen(landmarks_.size());
  for (const auto& match : matches(frame)) seen[match.landmark] = true;
  for (std::size_t j = 0; j < landmarks_.size(); ++j) {
    Landmark& landmark = landmarks_[j];
    if (seen[j] || landmark.object_class == "obstacle") continue;
    const Vec2 towards = landmark.place.mean_m - Vec2(frame.x_m, frame.y_m);
    const double range_m = towards.norm();
    const double azimuth_rad = wrap_angle(std::atan2(towards.y(), towards.x()) - frame.heading_rad);
    const bool in_plain_view =
        range_m > kPlainViewFrom_m && range_m < kPlainViewTo_m &&
        std::abs(azimuth_rad) < frame.view_angle_rad / 2 - kPictureEdge_rad &&
        !hides(frame, azimuth_rad, range_m);
    if (in_plain_view) landmark.certainty -= period_s / kAbsenceNoticed_s;
  }
  std::erase_if(landmarks_, [](const Landmark& landmark) { return landmark.certainty <= 0; });
}

void RobotMemory::touch(const msg::Variable& obstacle, Time now) {
  fade(now);
  const Gaussian2 place{{obstacle.values[0], obstacle.values[1]},
                        kTouchVariance_m2 * Mat2::Identity()};
  for (auto& landmark : landmarks_)
    if (landmark.object_class == "obstacle" &&
        squared_mahalanobis(landmark.place, place) < same_thing_gate()) {
      confirm(landmark, place, now);
      landmark.certainty = std::max<double>(landmark.certainty, obstacle.certainty);
      return;
    }
  landmarks_.push_back({"obstacle", place, obstacle.certainty, now, now});
}

void RobotMemory::fade(Time now) {
  for (auto& landmark : landmarks_) {
    landmark.certainty -= to_seconds(now - landmark.faded) / kMemory_s;
    landmark.faded = now;
  }
  std::erase_if(landmarks_, [](const Landmark& landmark) { return landmark.certainty <= 0; });
}

void RobotMemory::forget(std::uint64_t object_id) {
  std::erase_if(landmarks_,
                [&](const Landmark& landmark) { return landmark.object_id == object_id; });
}

}  // namespace galilean::monitor
