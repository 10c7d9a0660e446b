// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "core/random.h"
#include "sim/camera/canvas.h"

namespace galilean::sim {

/// The carpet below the horizon, and the hall with its dark ceiling above. They are drawn once,
/// with the noise in them, and then copied row by row. The hall is a panorama that turns with the
/// robot.
class Backdrop {
 public:
  Backdrop(const CameraGeometry& camera, const NoiseTable& noise, Random random);

  /// Fills the whole picture. `shift_px` moves the carpet's grain.
  void paint(Canvas& canvas, double heading_rad, std::uint32_t shift_px) const;

 private:
  static constexpr int kSlack_px = 256;
  static constexpr int kCarpetWidth = Canvas::kWidth + kSlack_px;

  void make_hall(const NoiseTable& noise, Random random);
  void make_carpet(const CameraGeometry& camera, const NoiseTable& noise, Random random);

  int camera_width_px_ = 0;
  int horizon_ = 0;
  int turn_px_ = 0;  ///< columns of a whole turn
  std::vector<std::uint8_t> hall_;
  std::vector<std::uint8_t> carpet_;
};

}  // namespace galilean::sim
