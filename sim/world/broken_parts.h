// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace galilean::sim {

/// The parts of one robot that an instructor broke. The body reads the bumpers and the wheels; the
/// devices read the camera, the serial line and the board.
struct BrokenParts {
  std::uint8_t dead_bumpers = 0;   ///< bit n: switch n never closes
  std::uint8_t stuck_bumpers = 0;  ///< bit n: switch n is always closed
  bool camera = false;
  bool serial_line = false;
  bool board = false;       ///< it has no power; mended, it starts anew
  bool left_wheel = false;  ///< its motor gets no power
  bool right_wheel = false;

  bool operator==(const BrokenParts&) const = default;
};

}  // namespace galilean::sim
