// SPDX-License-Identifier: BSD-3-Clause
#include "robot/perceptual/blob_detector.h"

#include <algorithm>
#include <cmath>

#include "core/device/device_names.h"
#include "core/device/devices.h"
#include "core/device/frame_grabber.h"

namespace galilean::robot {
namespace {

constexpr double kHalfCertainError_m = 0.5;

/// Returns the pose [odom] at which the picture was taken, extrapolated back with the present
/// speed.
Pose2 pose_at(const Shaft& shaft, Duration ago) noexcept {
  const double s = std::clamp(to_seconds(ago), 0.0, 0.5);
  Pose2 pose = shaft.pose;
  pose.position_m -= shaft.speed_mps * s * unit_vector(pose.heading_rad);
  pose.heading_rad = wrap_angle(pose.heading_rad - shaft.turn_rate_radps * s);
  return pose;
}

/// Returns the covariance [m²] in the odom frame. If the range is only an upper bound, every
/// smaller range is equally likely, which gives the variance range²/12 along the ray.
Mat2 covariance(const FloorPoint& point, bool range_is_bound, const Pose2& robot) noexcept {
  Mat2 in_robot = point.covariance_m2;
  if (range_is_bound) {
    const Vec2 ray = unit_vector(kPi / 2 + point.azimuth_rad);
    in_robot += point.range_m * point.range_m / 12 * ray * ray.transpose();
  }
  Mat2 turn;
  turn << direction_to_global(robot, Vec2::UnitX()), direction_to_global(robot, Vec2::UnitY());
  return turn * in_robot * turn.transpose();
}

/// Counts pixels of at least `level` beside and above the blob, within its bounds widened by half
/// its height. A robot has its bright panel there, and the blob may be that robot's tracks.
int bright_around(const Image& image, const Blob& blob, int level) noexcept {
  const int margin = std::max(3, (blob.bottom_px - blob.top_px + 1) / 2);
  const int left = std::max(0, blob.left_px - margin);
  const int right = std::min(Image::kWidth - 1, blob.right_px + margin);
  const int top = std::max(0, blob.top_px - margin);
  int count = 0;
  for (int y = top; y <= blob.bottom_px; ++y) {
    const std::uint8_t* row = image.pixels.data() + y * Image::kWidth;
    count += static_cast<int>(
        std::count_if(row + left, row + right + 1, [level](int pixel) { return pixel >= level; }));
  }
  return count;
}

}  // namespace

void BlobDetector::describe(Declaration<BlobDetector>& is) {
  is.help("Locates the nearest object of one class in an image.");
  describe_connections(is);
  describe_appearance(is);
  describe_rejections(is);
  is.number(static_cast<Number>(&TargetMemory::switch_distance_m), "switch_distance",
            unit::kCentimetre, 30,
            "how much nearer another object must be before the detector switches to it")
      .range(0, 1000);
  is.number(static_cast<Number>(&TargetMemory::miss_penalty), "miss_penalty", unit::kNone, 0.1,
            "certainty lost with each picture in which a remembered place is in view and empty")
      .range(0, 1);
  is.needs(kFrameGrabberName);
  is.uses_devices(&BlobDetector::devices_);
}

void BlobDetector::describe_connections(Declaration<BlobDetector>& is) {
  is.reads(&BlobDetector::image_, "image_variable", "the image in which the object is looked for");
  is.reads(&BlobDetector::shaft_, "shaft_variable", "where the robot is");
  is.updates(&BlobDetector::locate_, "locate_variable",
             "the object: its class and radius say what is looked for")
      .role(Role::kSighting, "image_variable");
  is.reads(&BlobDetector::companion_, "companion_image",
           "image that is bright beside what must be rejected")
      .optional();
  is.reads(&BlobDetector::reject_near_, "reject_near_variable",
           "located object near which everything is rejected")
      .optional();
}

void BlobDetector::describe_appearance(Declaration<BlobDetector>& is) {
  is.choice(&BlobDetector::polarity_, "polarity", {"bright", "dark"}, "bright",
            "whether the object's pixels are at least, or less than, the threshold")
      .role(Role::kPolarity, "image_variable");
  is.number(&BlobDetector::threshold_, "threshold", unit::kNone, 60,
            "brightness from 0 to 255 that divides the object's pixels from the others")
      .range(0, 255)
      .role(Role::kThreshold, "image_variable");
  is.choice(&BlobDetector::aim_, "aim", {"centroid", "lowest"}, "centroid",
            "which column tells the azimuth: the blob's mean, or that of its lowest pixels (for "
            "wide obstacles)");
  is.number(static_cast<Number>(&BlobGates::min_area_px), "min_area", unit::kSquarePixel, 12,
            "smallest blob")
      .range(1, Image::kWidth * Image::kHeight)
      .role(Role::kLeastArea, "image_variable");
  is.number(static_cast<Number>(&BlobGates::max_area_px), "max_area", unit::kSquarePixel,
            Image::kWidth * Image::kHeight, "largest blob")
      .range(1, Image::kWidth * Image::kHeight);
  is.number(static_cast<Number>(&BlobGates::min_aspect), "min_aspect", unit::kNone, 0,
            "least ratio of the object's width to its height")
      .range(0, 1000);
  is.number(static_cast<Number>(&BlobGates::max_aspect), "max_aspect", unit::kNone, 1000,
            "greatest ratio of the object's width to its height")
      .range(0, 1000);
  is.number(static_cast<Number>(&BlobGates::min_fill), "min_fill", unit::kNone, 0,
            "least fraction of its bounding box that a blob must fill")
      .range(0, 1);
}

void BlobDetector::describe_rejections(Declaration<BlobDetector>& is) {
  const auto length = [&is](double BlobGates::*member, const char* name, double default_cm,
                            const char* help) {
    is.number(static_cast<Number>(member), name, unit::kCentimetre, default_cm, help)
        .range(0, 10000);
  };
  length(&BlobGates::min_width_m, "min_width", 0, "least width of the object");
  length(&BlobGates::max_width_m, "max_width", 10000, "greatest width of the object");
  length(&BlobGates::min_height_m, "min_height", 0, "least height of its top over the floor");
  length(&BlobGates::max_height_m, "max_height", 10000,
         "greatest height of its top over the floor, which excludes ceilings");
  length(&BlobGates::max_range_m, "max_range", 1000, "how far from the camera it may stand");
  is.number(&BlobDetector::companion_threshold_, "companion_threshold", unit::kNone, 40,
            "brightness of a pixel of companion_image that counts")
      .range(0, 255)
      .only_with("companion_image");
  is.number(&BlobDetector::companion_area_px_, "companion_area", unit::kSquarePixel, 10,
            "how many such pixels around a blob reject it")
      .range(1, Image::kWidth * Image::kHeight)
      .only_with("companion_image");
  is.number(&BlobDetector::reject_radius_m_, "reject_radius", unit::kCentimetre, 40,
            "how far from reject_near_variable everything is rejected")
      .range(0, 1000)
      .only_with("reject_near_variable");
}

void BlobDetector::run(const Tick& tick) {
  if (!image_->valid_at(tick.now) || !shaft_->valid_at(tick.now)) return;
  const Image& image = image_->value;
  if (image.frame == last_frame_) return;
  last_frame_ = image.frame;
  const CameraModel camera(devices_->frame_grabber.geometry());
  const View view{camera, pose_at(shaft_->value, tick.now - image.captured)};
  collect(view, tick.now);
  locate_->value.sightings.clear();
  for (const Candidate& found : candidates_) locate_->value.sightings.push_back(found.sighting);
  locate_->value.sightings_frame = image.frame;
  update(*locate_, candidates_, view, tick);
}

void BlobDetector::collect(const View& view, Time now) noexcept {
  const Threshold threshold{static_cast<std::uint8_t>(threshold_), polarity_};
  candidates_.clear();
  for (const Blob& blob :
       finder_.find(image_->value.pixels, threshold, static_cast<std::uint32_t>(min_area_px)))
    if (const auto found = candidate(blob, view, now)) insert(*found);
}

std::optional<Candidate> BlobDetector::candidate(const Blob& blob, const View& view,
                                                 Time now) const noexcept {
  const double column = aim_ == Aim::kLowest ? blob.lowest_column_px : blob.centroid_column_px;
  const double radius_m = locate_->value.radius_m;
  const auto front = view.camera.floor_point(column + 0.5, blob.bottom_px + 1, 0);
  const auto centre = view.camera.floor_point(column + 0.5, blob.bottom_px + 1, radius_m);
  if (!front || !admit(blob, *front, view.camera) || has_companion(blob, now)) return std::nullopt;

  Candidate result;
  Sighting& sighting = result.sighting;
  sighting.position_m = point_to_global(view.robot, centre->in_robot_m);
  if (near_rejected(sighting.position_m, now)) return std::nullopt;
  result.range_is_bound = cut_by_bottom(blob);
  sighting.covariance_m2 = covariance(*centre, result.range_is_bound, view.robot);
  sighting.range_m = centre->range_m;
  sighting.azimuth_rad = centre->azimuth_rad;
  sighting.left_px = static_cast<std::uint16_t>(blob.left_px);
  sighting.top_px = static_cast<std::uint16_t>(blob.top_px);
  sighting.right_px = static_cast<std::uint16_t>(blob.right_px);
  sighting.bottom_px = static_cast<std::uint16_t>(blob.bottom_px);
  sighting.area_px = blob.area_px;
  result.certainty = certainty(blob, *front);
  return result;
}

bool BlobDetector::has_companion(const Blob& blob, Time now) const noexcept {
  return companion_ && companion_->valid_at(now) &&
         bright_around(companion_->value, blob, companion_threshold_) >= companion_area_px_;
}

bool BlobDetector::near_rejected(const Vec2& position_m, Time now) const noexcept {
  return reject_near_ && reject_near_->valid_at(now) &&
         (reject_near_->value.position_m - position_m).norm() <= reject_radius_m_;
}

double BlobDetector::certainty(const Blob& blob, const FloorPoint& front) const noexcept {
  const double of_area = blob.area_px / (blob.area_px + min_area_px);
  return of_area / (1 + std::pow(front.range_error_m / kHalfCertainError_m, 2));
}

void BlobDetector::insert(const Candidate& candidate) noexcept {
  const auto farther = [&](const Candidate& other) {
    return other.sighting.range_m > candidate.sighting.range_m;
  };
  Candidate moving = candidate;
  for (Candidate& held : candidates_)
    if (farther(held)) std::swap(held, moving);
  candidates_.push_back(moving);
}

}  // namespace galilean::robot
