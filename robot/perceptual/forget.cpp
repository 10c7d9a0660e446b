// SPDX-License-Identifier: BSD-3-Clause
#include "robot/perceptual/forget.h"

namespace galilean::robot {

void Forget::describe(Declaration<Forget>& is) {
  is.help("Sets how fast the certainty of variables falls while no schema writes them.");
  is.adjusts(&Forget::variables_, "variables", "what is forgotten, of whatever type");
  is.number(&Forget::time_s_, "time", unit::kSecond, 60,
            "in which certainty falls from 1 to 0; 0: never")
      .range(0, 86400);
}

void Forget::run(const Tick&) {
  const double decay_per_s = time_s_ > 0 ? 1 / time_s_ : 0;
  for (Reliability* reliability : variables_) reliability->decay_per_s = decay_per_s;
}

}  // namespace galilean::robot
