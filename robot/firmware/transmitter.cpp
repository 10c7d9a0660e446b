// SPDX-License-Identifier: BSD-3-Clause
#include "robot/firmware/transmitter.h"

#include <algorithm>

namespace galilean::robot::firmware {

void Transmitter::queue(std::span<const std::uint8_t> frame) {
  if (frame.size() > waiting_.size() - length_) return;
  std::copy(frame.begin(), frame.end(), waiting_.begin() + static_cast<std::ptrdiff_t>(length_));
  length_ += frame.size();
}

void Transmitter::drop_first(std::size_t count) {
  std::copy(waiting_.begin() + static_cast<std::ptrdiff_t>(count),
            waiting_.begin() + static_cast<std::ptrdiff_t>(length_), waiting_.begin());
  length_ -= count;
}

}  // namespace galilean::robot::firmware
