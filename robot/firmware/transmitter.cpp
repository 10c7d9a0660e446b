#include "robot/firmware/transmitter.h"

#include <algorithm>

namespace galilean::robot::firmware {

void Transmitter::queue(std::span<const std::uint8_t> frame) {
  if (frame.size() > waiting_.size() - length_) return;
  std::copy(frame.begin(), frame.end(), waiting_.begin() + static_cast<std::ptrdiff_t>(length_));
  length_ += frame.size();
}

void Transmitter::flush(Hardware& hardware) {
  if (length_ == 0) return;
  const std::size_t taken = hardware.send(std::span(waiting_).first(length_));
  std::copy(waiting_.begin() + static_cast<std::ptrdiff_t>(taken),
            waiting_.begin() + static_cast<std::ptrdiff_t>(length_), waiting_.begin());
  length_ -= taken;
}

}  // namespace galilean::robot::firmware
