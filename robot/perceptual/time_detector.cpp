// SPDX-License-Identifier: BSD-3-Clause
#include "robot/perceptual/time_detector.h"

namespace galilean::robot {

void TimeDetector::describe(Declaration<TimeDetector>& is) {
  is.help("Sets a bit when a time has passed since the state was entered.");
  is.updates(&TimeDetector::bits_, "bits_variable", "holds the bit");
  is.number(&TimeDetector::bit_index_, "bit_index", unit::kNone, 0, "which bit")
      .range(0, 31)
      .bit_of("bits_variable");
  is.required_number(&TimeDetector::duration_s_, "duration", unit::kSecond, "the time")
      .range(0, 86400)
      .role(Role::kTimeAtLeast);
}

void TimeDetector::activate(const Tick& tick) {
  activated_ = tick.now;
}

void TimeDetector::run(const Tick& tick) {
  Bits bits = bits_->value;
  bits.assign(bit_index_, tick.now - activated_ >= from_seconds(duration_s_));
  bits_->write(bits, 1, tick.now, tick.number);
}

}  // namespace galilean::robot
