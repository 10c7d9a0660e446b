// SPDX-License-Identifier: BSD-3-Clause
#include "robot/perceptual/blob_gates.h"

#include <algorithm>

namespace galilean::robot {

bool cut_by_bottom(const Blob& blob) noexcept {
  return blob.bottom_px == Image::kHeight - 1;
}

bool cut_by_other_edge(const Blob& blob) noexcept {
  return blob.left_px == 0 || blob.right_px == Image::kWidth - 1 || blob.top_px == 0;
}

bool BlobGates::admit(const Blob& blob, const FloorPoint& front,
                      const CameraModel& camera) const noexcept {
  const int columns = blob.right_px - blob.left_px + 1;
  const int rows = blob.bottom_px - blob.top_px + 1;
  if (blob.area_px < min_area_px || blob.area_px > max_area_px) return false;
  if (blob.area_px < min_fill * columns * rows) return false;
  if (front.range_m > max_range_m) return false;

  const bool foot_seen = !cut_by_bottom(blob);
  const bool sides_seen = !cut_by_other_edge(blob);
  const double width_m = camera.width_m(columns, front.depth_m);
  const double seen_height_m = camera.height_m(blob.top_px, front.depth_m);
  const double height_m =
      foot_seen ? seen_height_m : std::max(seen_height_m, camera.geometry().height_m);
  if (foot_seen && (width_m > max_width_m || height_m > max_height_m)) return false;
  if (sides_seen && (width_m < min_width_m || height_m < min_height_m)) return false;
  if (!foot_seen || !sides_seen) return true;
  return width_m >= min_aspect * height_m && width_m <= max_aspect * height_m;
}

}  // namespace galilean::robot
