// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/catalog/declaration.h"
#include "core/schema/schema.h"
#include "core/variable/variable.h"

namespace galilean {
struct Devices;
}

namespace galilean::robot {

/// Splits a new camera picture into supercomponents and intensity.
///
///   reads   frame_grabber
///   writes  red_variable, green_variable, blue_variable: the supercomponents; dark_variable: the
///           intensity, in which baskets are dark. Those that are named, and only when there is a
///           new frame.
///   law     superred = max(0, R - (G + B)), and so on; intensity = (R + 2G + B) / 4; normalised by
///           a gain common to the picture (see robot/vision/supercomponent.h)
///   source  the paper
class Look final : public PerceptualSchema {
 public:
  static void describe(Declaration<Look>& is);
  void run(const Tick& tick) override;
  void keep(Memory& memory) noexcept override { memory.keep(last_frame_); }

 private:
  Variable<Image>* red_ = nullptr;
  Variable<Image>* green_ = nullptr;
  Variable<Image>* blue_ = nullptr;
  Variable<Image>* dark_ = nullptr;
  bool normalise_ = true;
  std::uint64_t last_frame_ = 0;
  const Devices* devices_ = nullptr;
};

}  // namespace galilean::robot
