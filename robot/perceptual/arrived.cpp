// SPDX-License-Identifier: BSD-3-Clause
#include "robot/perceptual/arrived.h"

#include "robot/variables/relative.h"

namespace galilean::robot {

void Arrived::describe(Declaration<Arrived>& is) {
  is.help("Sets a bit while the robot is close to an object that it sees or remembers.");
  is.reads(&Arrived::object_, "locate_variable", "the object");
  is.reads(&Arrived::shaft_, "shaft_variable", "where the robot is").default_value("shaft");
  is.number(&Arrived::radius_m_, "radius", unit::kCentimetre, 40,
            "distance between the centres of robot and object within which the robot has arrived")
      .range(0, 10000)
      .role(Role::kDistanceAtMost, "locate_variable");
  is.updates(&Arrived::bits_, "bits_variable", "holds the bit");
  is.number(&Arrived::bit_index_, "bit_index", unit::kNone, 0, "which bit")
      .range(0, 31)
      .bit_of("bits_variable");
}

void Arrived::run(const Tick& tick) {
  const auto object = relative_object(*object_, *shaft_, tick.now);
  Bits bits = bits_->value;
  bits.assign(bit_index_, object && object->distance_m <= radius_m_);
  bits_->write(bits, 1, tick.now, tick.number);
}

}  // namespace galilean::robot
