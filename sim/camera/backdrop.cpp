// SPDX-License-Identifier: BSD-3-Clause
#include "sim/camera/backdrop.h"

#include <algorithm>
#include <cmath>

namespace galilean::sim {
namespace {

constexpr Colour kHallWall{120, 118, 116};
constexpr Colour kCeiling{92, 90, 92};
constexpr Colour kDarkCeiling{20, 19, 22};
constexpr Colour kLamp{250, 250, 245};
constexpr Colour kCarpet{134, 126, 116};

Colour mixed(Colour a, Colour b, double share) {
  const auto mix = [&](int x, int y) { return static_cast<std::uint8_t>(x + share * (y - x)); };
  return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue)};
}

void write(std::uint8_t* at, Colour colour, int grain, const NoiseTable& noise,
           std::uint32_t place) {
  at[0] = to_level(colour.red + grain + noise.at(place));
  at[1] = to_level(colour.green + grain + noise.at(place + 7));
  at[2] = to_level(colour.blue + grain + noise.at(place + 19));
}

/// A dark area or a row of lamps in the ceiling, in columns of the panorama and rows from the top.
struct Patch {
  int left, right, top, bottom;
  Colour colour;
};

std::vector<Patch> draw_patches(int turn_px, int horizon, Random& random) {
  std::vector<Patch> patches;
  for (int column = 0; column < turn_px;) {
    const int width = 30 + static_cast<int>(random.below(90));
    const bool lamp = random.below(4) == 0;
    const int top = static_cast<int>(random.below(static_cast<std::uint32_t>(horizon / 2)));
    const int height = lamp ? 5 : 12 + static_cast<int>(random.below(26));
    patches.push_back({column, column + (lamp ? width / 2 : width), top,
                       std::min(top + height, horizon - 18), lamp ? kLamp : kDarkCeiling});
    column += width + 10 + static_cast<int>(random.below(80));
  }
  return patches;
}

}  // namespace

Backdrop::Backdrop(const CameraGeometry& camera, const NoiseTable& noise, Random random) {
  const View view(camera, {});
  camera_width_px_ = camera.width_px;
  horizon_ = static_cast<int>(view.horizon_row());
  turn_px_ = static_cast<int>(2 * kPi * view.focal_columns_px());
  make_hall(noise, random.child("hall"));
  make_carpet(camera, noise, random.child("carpet"));
}

void Backdrop::make_hall(const NoiseTable& noise, Random random) {
  const int width = turn_px_ + Canvas::kWidth;
  hall_.resize(static_cast<std::size_t>(width * horizon_ * 3));
  const auto patches = draw_patches(turn_px_, horizon_, random);
  for (int row = 0; row < horizon_; ++row)
    for (int column = 0; column < width; ++column) {
      Colour colour = mixed(kCeiling, kHallWall, static_cast<double>(row) / horizon_);
      for (const Patch& patch : patches) {
        const int here = column % turn_px_;
        if (here >= patch.left && here < patch.right && row >= patch.top && row < patch.bottom)
          colour = patch.colour;
      }
      write(&hall_[static_cast<std::size_t>((row * width + column) * 3)], colour, 0, noise,
            static_cast<std::uint32_t>(random.bits()));
    }
}

void Backdrop::make_carpet(const CameraGeometry& camera, const NoiseTable& noise, Random random) {
  const int rows = camera.height_px - horizon_;
  carpet_.resize(static_cast<std::size_t>(kCarpetWidth * rows * 3));
  for (int row = 0; row < rows; ++row) {
    const double light = 0.72 + 0.28 * row / rows;
    const Colour colour = mixed({}, kCarpet, light);
    for (int column = 0; column < kCarpetWidth; ++column) {
      const int pile = static_cast<int>(random.below(9)) - 4;
      write(&carpet_[static_cast<std::size_t>((row * kCarpetWidth + column) * 3)], colour, pile,
            noise, static_cast<std::uint32_t>(random.bits()));
    }
  }
}

void Backdrop::paint(Canvas& canvas, double heading_rad, std::uint32_t shift_px) const {
  const auto row_bytes = static_cast<std::size_t>(camera_width_px_) * 3;
  // When the camera turns to the left, what lies to the left comes into view.
  const double turns = -heading_rad / (2 * kPi);
  const int hall_column = static_cast<int>((turns - std::floor(turns)) * turn_px_) % turn_px_;
  const int hall_width = turn_px_ + Canvas::kWidth;
  for (int row = 0; row < horizon_; ++row)
    std::memcpy(canvas.pixel(0, row),
                &hall_[static_cast<std::size_t>((row * hall_width + hall_column) * 3)],
                Canvas::kWidth * 3);
  for (int row = horizon_; row < Canvas::kHeight; ++row) {
    const auto shift = static_cast<int>((shift_px + static_cast<std::uint32_t>(row) * 97) %
                                        static_cast<std::uint32_t>(kSlack_px));
    const int from = (row - horizon_) * kCarpetWidth + shift;
    std::memcpy(canvas.pixel(0, row), &carpet_[static_cast<std::size_t>(from * 3)], row_bytes);
  }
}

}  // namespace galilean::sim
