// SPDX-License-Identifier: BSD-3-Clause
#include "robot/motor/noise.h"

namespace galilean::robot {

void Noise::describe(Declaration<Noise>& is) {
  is.help("Wanders: a force in a random heading, held for a while.");
  is.reads(&Noise::shaft_, "shaft_variable", "where the robot is");
  is.number(&Noise::persistence_s_, "persistence", unit::kSecond, 5,
            "time for which a heading is held")
      .range(0, 86400);
  is.writes(&Noise::result_, "result", "the force");
  is.uses_random(&Noise::random_);
}

void Noise::activate(const Tick& tick) {
  heading_ = random_.heading();
  drawn_ = tick.now;
}

void Noise::run(const Tick& tick) {
  if (!shaft_->valid_at(tick.now)) return;
  if (!drawn_ || tick.now - *drawn_ >= from_seconds(persistence_s_)) activate(tick);
  result_->write({direction_to_robot(shaft_->value.pose, heading_)}, shaft_->certainty_at(tick.now),
                 tick.now, tick.number);
}

}  // namespace galilean::robot
