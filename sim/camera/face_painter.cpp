// SPDX-License-Identifier: BSD-3-Clause
#include "sim/camera/face_painter.h"

#include <algorithm>
#include <cmath>

namespace galilean::sim {
namespace {

constexpr int kStrips = 8;

/// Returns a number in [0, 1) for a place on the cloth. It is the same each time.
float scattered(int place) noexcept {
  auto x = static_cast<std::uint32_t>(place) * 0x9e3779b1u;
  x = (x ^ (x >> 15)) * 0x85ebca77u;
  return static_cast<float>((x ^ (x >> 13)) >> 8) / static_cast<float>(1 << 24);
}

/// Returns the brightness of the cloth. It has one fold every 16 cm, and some are deep: a dark line
/// 2 to 5 cm wide.
float light_of_folds(float along_m) noexcept {
  constexpr float kPitch_m = 0.16f;
  const float folds = along_m / kPitch_m;
  const int number = static_cast<int>(std::floor(folds));
  const float in_fold = (folds - static_cast<float>(number)) * kPitch_m;
  const float wave = 0.85f + 0.15f * std::abs(in_fold / kPitch_m * 2 - 1);
  const bool deep = scattered(number) < 0.35f;
  const float width_m = 0.02f + 0.03f * scattered(number + 7919);
  return deep && in_fold < width_m ? 0.18f : wave;
}

float light_of_panels(float along_m) noexcept {
  const float in_panel = along_m - std::floor(along_m);
  return in_panel < 0.015f ? 0.75f : 1.0f;
}

float light_at(Texture texture, float along_m) noexcept {
  switch (texture) {
    case Texture::kFolds:
      return light_of_folds(along_m);
    case Texture::kPanels:
      return light_of_panels(along_m);
    case Texture::kPlain:
      break;
  }
  return 1;
}

/// Returns a factor that makes distant faces a little darker.
float haze(float inverse_depth) noexcept {
  return 0.8f + 0.2f * std::min(1.0f, inverse_depth);
}

/// The same row of pixels several times over. Each copy has its own noise.
struct Strips {
  alignas(16) std::uint8_t rgb[kStrips][Canvas::kWidth * 3];
};

/// The place on the face that a column shows. In perspective, (along / depth) is linear in the
/// column, but along is not.
class Along {
 public:
  explicit Along(const ProjectedFace& face) noexcept
      : start_(face.along_left_m * face.inverse_left),
        slope_((face.along_right_m * face.inverse_right - start_) / (face.right_px - face.left_px)),
        left_px_(face.left_px) {}
  [[nodiscard]] float at(float column, float inverse_depth) const noexcept {
    return (start_ + slope_ * (column - left_px_)) / inverse_depth;
  }

 private:
  float start_, slope_, left_px_;
};

/// Draws the band without noise, one pixel a column.
void shade(const Face& face, const Band& band, const ProjectedFace& projected, int first, int last,
           std::uint8_t* rgb) {
  const Along along(projected);
  const float slope = projected.slope();
  float inverse = projected.inverse_at(static_cast<float>(first) + 0.5f);
  for (int column = first; column < last; ++column, inverse += slope, rgb += 3) {
    float light = face.light * haze(inverse);
    if (band.texture != Texture::kPlain)
      light *= light_at(band.texture, along.at(static_cast<float>(column) + 0.5f, inverse));
    rgb[0] = static_cast<std::uint8_t>(band.colour.red * light);
    rgb[1] = static_cast<std::uint8_t>(band.colour.green * light);
    rgb[2] = static_cast<std::uint8_t>(band.colour.blue * light);
  }
}

void make_strips(const Canvas& canvas, const Face& face, const Band& band,
                 const ProjectedFace& projected, int first, int last, Strips& strips) {
  std::uint8_t clean[Canvas::kWidth * 3];
  shade(face, band, projected, first, last, clean);
  const auto bytes = static_cast<std::size_t>(last - first) * 3;
  std::uint32_t place = canvas.noise_place + static_cast<std::uint32_t>(band.top_m * 4096);
  for (auto& strip : strips.rgb) {
    canvas.noise.add(clean, bytes, place, strip + first * 3);
    place = place * 5 + 1021;
  }
}

/// A straight edge of a trapezoid: row = at_zero + slope · column.
struct Edge {
  float at_zero;
  float slope;
  [[nodiscard]] float at(float column) const noexcept { return at_zero + slope * column; }
};

Edge edge_at_height(const Canvas& canvas, const ProjectedFace& face, float height_m) {
  const float left = canvas.view.row(height_m, face.inverse_left);
  const float right = canvas.view.row(height_m, face.inverse_right);
  const float slope = (right - left) / (face.right_px - face.left_px);
  return {left - slope * face.left_px, slope};
}

/// Narrows [first, last) to the columns where the edge lies above the row's middle, or below it.
void keep_columns(const Edge& edge, float row, bool above, int& first, int& last) {
  constexpr float kLevel = 1e-6f;
  if (std::abs(edge.slope) < kLevel) {
    if ((edge.at_zero <= row) != above) last = first;
    return;
  }
  const float crossing = (row - edge.at_zero) / edge.slope;
  const int pixel = first_pixel(crossing, Canvas::kWidth);
  const bool keep_left = (edge.slope > 0) == above;
  if (keep_left)
    last = std::min(last, pixel);
  else
    first = std::max(first, pixel);
}

/// Fills the rows of one band between two columns. Requires: nothing hides these columns.
void fill(Canvas& canvas, const Strips& strips, const Edge& top, const Edge& bottom, int first,
          int last) {
  const auto left = static_cast<float>(first);
  const auto right = static_cast<float>(last);
  const int first_row = first_pixel(std::min(top.at(left), top.at(right)), Canvas::kHeight);
  const int last_row = first_pixel(std::max(bottom.at(left), bottom.at(right)), Canvas::kHeight);
  std::uint32_t strip = canvas.noise_place;
  for (int row = first_row; row < last_row; ++row) {
    int from = first;
    int to = last;
    const float middle = static_cast<float>(row) + 0.5f;
    keep_columns(top, middle, true, from, to);
    keep_columns(bottom, middle, false, from, to);
    strip = strip * 1664525u + 1013904223u;
    if (from < to)
      std::memcpy(canvas.pixel(from, row), &strips.rgb[(strip >> 24) % kStrips][from * 3],
                  static_cast<std::size_t>(to - from) * 3);
  }
}

/// Calls `paint(first, last)` for each stretch of columns that no furniture hides.
template <class Paint>
void for_each_visible(const Canvas& canvas, const ProjectedFace& face, Paint&& paint) {
  int column = first_pixel(face.left_px, Canvas::kWidth);
  const int end = first_pixel(face.right_px, Canvas::kWidth);
  const auto hidden = [&](int c) {
    return canvas.hidden(c, face.inverse_at(static_cast<float>(c) + 0.5f));
  };
  while (column < end) {
    while (column < end && hidden(column)) ++column;
    const int first = column;
    while (column < end && !hidden(column)) ++column;
    if (first < column) paint(first, column);
  }
}

}  // namespace

void paint_face(Canvas& canvas, const Face& face, const ProjectedFace& projected) {
  Strips strips;
  for_each_visible(canvas, projected, [&](int first, int last) {
    for (std::uint8_t i = 0; i < face.band_count; ++i) {
      const Band& band = face.bands[i];
      make_strips(canvas, face, band, projected, first, last, strips);
      fill(canvas, strips, edge_at_height(canvas, projected, band.top_m),
           edge_at_height(canvas, projected, band.bottom_m), first, last);
    }
  });
}

void mark_furniture(Canvas& canvas, const ProjectedFace& projected) {
  const int end = first_pixel(projected.right_px, Canvas::kWidth);
  for (int column = first_pixel(projected.left_px, Canvas::kWidth); column < end; ++column) {
    float& nearest = canvas.furniture[static_cast<std::size_t>(column)];
    nearest = std::max(nearest, projected.inverse_at(static_cast<float>(column) + 0.5f));
  }
}

}  // namespace galilean::sim
