// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "robot/vision/blobs.h"
#include "robot/vision/camera_model.h"

namespace galilean::robot {

/// The limits that a blob must keep to pass as the object that a detector looks for. A blob that
/// the picture's edge cuts is judged only by its visible part. If the bottom edge cuts it, it is
/// nearer than its range says and so smaller than it seems: it is never refused as too large. If
/// another edge cuts it, it is larger than it seems: it is never refused as too small.
struct BlobGates {
  double min_area_px = 12;
  double max_area_px = Image::kWidth * Image::kHeight;
  double min_aspect = 0;  ///< width / height, in metres of the object
  double max_aspect = 0;
  double min_fill = 0;  ///< area / (width · height), in pixels
  double min_width_m = 0;
  double max_width_m = 0;
  double min_height_m = 0;
  double max_height_m = 0;  ///< the height of its top over the floor
  double max_range_m = 0;

  /// `front` is where the blob's lowest pixel meets the floor.
  [[nodiscard]] bool admit(const Blob& blob, const FloorPoint& front,
                           const CameraModel& camera) const noexcept;
};

[[nodiscard]] bool cut_by_bottom(const Blob& blob) noexcept;
[[nodiscard]] bool cut_by_other_edge(const Blob& blob) noexcept;

}  // namespace galilean::robot
