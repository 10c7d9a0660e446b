// SPDX-License-Identifier: BSD-3-Clause
#include "robot/perceptual/forget.h"

namespace galilean::robot {

void Forget::describe(Declaration<Forget>& is) {
  is.help("Sets how fast the certainty of variables falls while no schema writes them.");
  is.adjusts(&Forget::variables_, "variables", "the variables, of any type, whose certainty falls");
  is.number(&Forget::time_s_, "time", unit::kSecond, 60,
            "time in which certainty falls from 1 to 0; 0: it never falls")
      .range(0, 86400);
}

void Forget::run(const Tick&) {
  const double decay_per_s = time_s_ > 0 ? 1 / time_s_ : 0;
  for (Reliability* reliability : variables_) reliability->decay_per_s = decay_per_s;
}

}  // namespace galilean::robot
