// SPDX-License-Identifier: BSD-3-Clause
#include "robot/perceptual/seen.h"

#include "robot/variables/relative.h"

namespace galilean::robot {

void Seen::describe(Declaration<Seen>& is) {
  is.help("Sets a bit while the robot knows well enough where an object is.");
  is.reads(&Seen::object_, "locate_variable", "the object");
  is.reads(&Seen::shaft_, "shaft_variable", "where the robot is").default_value("shaft");
  is.number(&Seen::min_certainty_, "min_certainty", unit::kNone, 0.5,
            "least certainty of the object that counts as seen")
      .range(0, 1)
      .role(Role::kCertaintyAtLeast, "locate_variable");
  is.number(&Seen::max_range_m_, "max_range", unit::kCentimetre, 10000,
            "greatest distance from the robot at which the object counts as seen")
      .range(0, 10000);
  is.updates(&Seen::bits_, "bits_variable", "holds the bit");
  is.number(&Seen::bit_index_, "bit_index", unit::kNone, 0, "which bit")
      .range(0, 31)
      .bit_of("bits_variable");
}

void Seen::run(const Tick& tick) {
  Bits bits = bits_->value;
  bits.assign(bit_index_, holds(tick.now));
  bits_->write(bits, 1, tick.now, tick.number);
}

bool Seen::holds(Time now) const noexcept {
  const auto object = relative_object(*object_, *shaft_, now);
  return object && object_->certainty_at(now) >= min_certainty_ &&
         object->distance_m <= max_range_m_;
}

}  // namespace galilean::robot
