// SPDX-License-Identifier: BSD-3-Clause
#include "robot/perceptual/stuck_detector.h"

namespace galilean::robot {

void StuckDetector::describe(Declaration<StuckDetector>& is) {
  is.help("Sets a bit when something has been touched without a break for too long.");
  is.reads(&StuckDetector::contact_, "contact_variable", "the bumpers");
  is.number(&StuckDetector::duration_s_, "duration", unit::kSecond, 3,
            "how long something must be touched without a break before the bit is set")
      .range(0, 86400);
  is.updates(&StuckDetector::bits_, "bits_variable", "holds the bit");
  is.number(&StuckDetector::bit_index_, "bit_index", unit::kNone, 0, "which bit")
      .range(0, 31)
      .bit_of("bits_variable");
}

void StuckDetector::run(const Tick& tick) {
  const bool touches = contact_->reliability.valid_at(tick.now) && contact_->value.value != 0;
  const bool watched = tick.number == last_tick_ + 1;
  if (!touches || !watched) free_ = tick.now;
  last_tick_ = tick.number;
  Bits bits = bits_->value;
  bits.assign(bit_index_, touches && tick.now - free_ >= from_seconds(duration_s_));
  bits_->write(bits, 1, tick.now, tick.number);
}

}  // namespace galilean::robot
