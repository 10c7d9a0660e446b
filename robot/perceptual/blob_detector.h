// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/catalog/declaration.h"
#include "core/schema/schema.h"
#include "core/variable/variable.h"
#include "robot/perceptual/blob_gates.h"
#include "robot/perceptual/target_memory.h"
#include "robot/vision/blobs.h"

namespace galilean {
struct Devices;
}

namespace galilean::robot {

/// Locates the nearest object of one class in an image.
///
///   reads    image_variable, shaft_variable; companion_image, reject_near_variable where given
///   updates  locate_variable: position, covariance and certainty of the object chosen (see
///            TargetMemory); `sightings`: all that passed, nearest first. Only on a new frame.
///   law      a blob's lowest pixel tells where the object's front meets the floor (CameraModel);
///            its centre is the locate's radius further. certainty =
///            a / (a + min_area) / (1 + (e / 50 cm)²), a: area in pixels, e: what one row of pixels
///            makes of the range; halved if the picture's bottom edge cuts the blob and nothing is
///            remembered there: the range is then the nearest that the camera sees, an upper bound.
///   rejects  what does not reach below the horizon or rises above max_height (ceilings), what has
///            enough of the companion image's pixels beside it (dark under a green robot), what is
///            near a located object, and what has not the object's shape or size (folds of skirts)
///   source   the paper; CMVision (Bruce, Balch, Veloso 2000)
class BlobDetector final : public PerceptualSchema, private BlobGates, private TargetMemory {
 public:
  static void describe(Declaration<BlobDetector>& is);
  void run(const Tick& tick) override;
  void keep(Memory& memory) noexcept override { memory.keep(last_frame_); }

 private:
  using Number = double BlobDetector::*;
  static void describe_connections(Declaration<BlobDetector>& is);
  static void describe_appearance(Declaration<BlobDetector>& is);
  static void describe_rejections(Declaration<BlobDetector>& is);

  void collect(const View& view, Time now) noexcept;
  [[nodiscard]] std::optional<Candidate> candidate(const Blob& blob, const View& view,
                                                   Time now) const noexcept;
  [[nodiscard]] bool has_companion(const Blob& blob, Time now) const noexcept;
  [[nodiscard]] bool near_rejected(const Vec2& position_m, Time now) const noexcept;
  [[nodiscard]] double certainty(const Blob& blob, const FloorPoint& front) const noexcept;
  void insert(const Candidate& candidate) noexcept;

  enum class Aim { kCentroid, kLowest };

  const Variable<Image>* image_ = nullptr;
  const Variable<Shaft>* shaft_ = nullptr;
  Variable<Locate>* locate_ = nullptr;
  Polarity polarity_ = Polarity::kBright;
  int threshold_ = 0;
  Aim aim_ = Aim::kCentroid;
  const Variable<Image>* companion_ = nullptr;
  int companion_threshold_ = 0;
  int companion_area_px_ = 0;
  const Variable<Locate>* reject_near_ = nullptr;
  double reject_radius_m_ = 0;
  const Devices* devices_ = nullptr;

  std::uint64_t last_frame_ = 0;
  BlobFinder finder_;
  Candidates candidates_;
};

}  // namespace galilean::robot
