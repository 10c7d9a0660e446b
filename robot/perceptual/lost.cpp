// SPDX-License-Identifier: BSD-3-Clause
#include "robot/perceptual/lost.h"

namespace galilean::robot {

void Lost::describe(Declaration<Lost>& is) {
  is.help("Sets a bit while the robot does not know where an object is.");
  is.reads(&Lost::object_, "locate_variable", "the object");
  is.number(&Lost::min_certainty_, "min_certainty", unit::kNone, 0.2,
            "certainty below which the object is lost")
      .range(0, 1)
      .role(Role::kCertaintyBelow, "locate_variable");
  is.updates(&Lost::bits_, "bits_variable", "holds the bit");
  is.number(&Lost::bit_index_, "bit_index", unit::kNone, 0, "which bit")
      .range(0, 31)
      .bit_of("bits_variable");
}

void Lost::run(const Tick& tick) {
  const double certainty = object_->certainty_at(tick.now);
  Bits bits = bits_->value;
  bits.assign(bit_index_, certainty <= 0 || certainty < min_certainty_);
  bits_->write(bits, 1, tick.now, tick.number);
}

}  // namespace galilean::robot
