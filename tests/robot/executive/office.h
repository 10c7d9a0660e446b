// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/robot/executive/test_robot.h"

namespace galilean::robot {

/// Returns one of the programs that ship. The test fails if it has errors.
inline bhdl::Program shipped_program(const std::string& file) {
  auto checked =
      bhdl::check_file(GALILEAN_SOURCE_DIR "/bhdl/programs/" + file, test_components().catalog());
  for (const auto& diagnostic : checked.diagnostics)
    if (diagnostic.severity == bhdl::Severity::kError) ADD_FAILURE() << format(diagnostic);
  return checked.program.value();
}

/// Paints a grey floor with a red can on it, some way ahead.
inline void paint_office(Frame& frame) {
  frame.number = 1;
  for (int row = 0; row < Frame::kHeight; ++row)
    for (int column = 0; column < Frame::kWidth; ++column) {
      const bool can = row > 110 && row < 140 && column > 160 && column < 180;
      auto* pixel = &frame.rgb[static_cast<std::size_t>(3 * (row * Frame::kWidth + column))];
      pixel[0] = can ? 220 : 150;
      pixel[1] = pixel[2] = can ? 20 : 150;
    }
}

}  // namespace galilean::robot
