// SPDX-License-Identifier: BSD-3-Clause
#include "sim/camera/floor_painter.h"

#include <algorithm>
#include <cmath>

namespace galilean::sim {
namespace {

void blend_row(Canvas& canvas, int row, int first, int last, float inverse_depth,
               const FloorSpot& spot) {
  for (int column = first; column < last; ++column) {
    if (canvas.hidden(column, inverse_depth)) continue;
    std::uint8_t* at = canvas.pixel(column, row);
    for (int c = 0; c < 3; ++c)
      at[c] = static_cast<std::uint8_t>(at[c] + (spot.target - at[c]) * spot.weight / 256);
  }
}

}  // namespace

void paint_spot(Canvas& canvas, const FloorSpot& spot) {
  const View& view = canvas.view;
  const float near_m = std::max(spot.in_camera_m.y() - spot.radius_m, View::kNearest_m);
  const float far_m = spot.in_camera_m.y() + spot.radius_m;
  if (far_m <= View::kNearest_m) return;
  const int last_row = first_pixel(view.row(0, 1 / near_m), Canvas::kHeight);
  for (int row = first_pixel(view.row(0, 1 / far_m), Canvas::kHeight); row < last_row; ++row) {
    const float depth_m = view.floor_depth_m(static_cast<float>(row) + 0.5f);
    const float off_m = depth_m - spot.in_camera_m.y();
    const float half_m = std::sqrt(std::max(0.0f, spot.radius_m * spot.radius_m - off_m * off_m));
    blend_row(canvas, row,
              first_pixel(view.column(spot.in_camera_m.x() - half_m, depth_m), Canvas::kWidth),
              first_pixel(view.column(spot.in_camera_m.x() + half_m, depth_m), Canvas::kWidth),
              1 / depth_m, spot);
  }
}

}  // namespace galilean::sim
