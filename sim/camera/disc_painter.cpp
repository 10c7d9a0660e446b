// SPDX-License-Identifier: BSD-3-Clause
#include "sim/camera/disc_painter.h"

#include <algorithm>
#include <cmath>

namespace galilean::sim {
namespace {

struct Look {
  Colour side;
  Colour top;
  bool glossy;
  bool crumpled;
};

const Look& look_of(DiscKind kind) noexcept {
  static constexpr std::array<Look, 5> kLooks{{
      {{206, 34, 30}, {176, 172, 172}, true, false},
      {{196, 40, 36}, {150, 30, 28}, false, false},
      {{190, 44, 40}, {198, 52, 48}, false, true},
      {{20, 20, 22}, {14, 14, 15}, false, false},
      {{96, 96, 100}, {96, 96, 100}, true, false},
  }};
  return kLooks[static_cast<std::size_t>(kind)];
}

/// What one column of the picture shows of the cylinder.
struct Slice {
  float near_m;  ///< depth where the column's ray enters
  float far_m;   ///< depth where the ray leaves
  float across;  ///< -1 at the left rim … 1 at the right rim
};

bool cut(const Eigen::Vector2f& centre, float radius, float tangent, Slice& slice) noexcept {
  const float a = tangent * tangent + 1;
  const float b = tangent * centre.x() + centre.y();
  const float root = b * b - a * (centre.squaredNorm() - radius * radius);
  if (root <= 0) return false;
  const float half = std::sqrt(root);
  slice.near_m = std::max((b - half) / a, View::kNearest_m);
  slice.far_m = (b + half) / a;
  slice.across = (tangent * centre.y() - centre.x()) / (radius * std::sqrt(a));
  return slice.far_m > View::kNearest_m;
}

float light_across(const Look& look, float across) noexcept {
  const float round = std::sqrt(std::max(0.0f, 1 - across * across));
  return 0.62f + 0.38f * round - (look.crumpled ? 0.1f * std::abs(std::sin(9 * across)) : 0.0f);
}

/// Returns the cylinder's height [m] at `across`. Crumpled paper is lower towards its rim.
float height_across(const Disc& disc, const Look& look, float across) noexcept {
  if (!look.crumpled) return disc.height_m;
  const float round = std::sqrt(std::max(0.0f, 1 - across * across));
  return disc.height_m * (0.45f + 0.5f * round + 0.05f * std::sin(17 * across));
}

void paint_slice(Canvas& canvas, const Disc& disc, const Look& look, const Slice& slice,
                 int column) {
  const float height = height_across(disc, look, slice.across);
  const bool from_above = height < canvas.view.camera_height_m();
  const float rim_row = canvas.view.row(height, 1 / slice.near_m);
  const float top_row = from_above ? canvas.view.row(height, 1 / slice.far_m) : rim_row;
  const int top = first_pixel(top_row, Canvas::kHeight);
  const int rim = first_pixel(rim_row, Canvas::kHeight);
  const int bottom = first_pixel(canvas.view.row(0, 1 / slice.near_m), Canvas::kHeight);
  const float light = light_across(look, slice.across);
  const bool glare = look.glossy && std::abs(slice.across + 0.35f) < 0.1f;
  for (int row = top; row < rim; ++row) canvas.put(column, row, look.top, light);
  for (int row = rim; row < bottom; ++row) {
    const bool shines = glare && row - rim < (bottom - rim) / 2;
    canvas.put(column, row, shines ? Colour{236, 226, 222} : look.side, shines ? 1 : light);
  }
}

}  // namespace

void paint_disc(Canvas& canvas, const Disc& disc, const Eigen::Vector2f& in_camera_m) {
  const float distance = in_camera_m.norm();
  const float reach = disc.radius_m * 1.5f;
  if (in_camera_m.y() <= reach * 0.5f || distance <= disc.radius_m) return;
  const Look& look = look_of(disc.kind);
  const float bearing = std::atan2(in_camera_m.x(), in_camera_m.y());
  const float half = std::asin(disc.radius_m / distance);
  const float right = std::min(bearing + half, 1.4f);
  const float left = std::max(bearing - half, -1.4f);
  if (left >= right) return;
  const int end = first_pixel(canvas.view.column(std::tan(right), 1) + 1, Canvas::kWidth);
  const float inverse = 1 / in_camera_m.y();
  for (int column = first_pixel(canvas.view.column(std::tan(left), 1) - 1, Canvas::kWidth);
       column < end; ++column) {
    Slice slice;
    const bool seen = !canvas.hidden(column, inverse) &&
                      cut(in_camera_m, disc.radius_m,
                          canvas.view.tangent(static_cast<float>(column) + 0.5f), slice);
    if (seen) paint_slice(canvas, disc, look, slice, column);
  }
}

}  // namespace galilean::sim
