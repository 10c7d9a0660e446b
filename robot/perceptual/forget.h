// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/catalog/declaration.h"
#include "core/schema/schema.h"
#include "core/variable/variable.h"

namespace galilean::robot {

/// Sets how fast the robot forgets.
///
///   updates  variables (of any type): the rate at which their certainty falls
///   law      certainty(t) = certainty(t_write) - (t - t_write) / time, never below 0;
///            t_write is the time of the last write by a schema. The rate stays after the schema
///            has run.
///   source   the paper's "forget variables"
class Forget final : public PerceptualSchema {
 public:
  static void describe(Declaration<Forget>& is);
  void run(const Tick& tick) override;

 private:
  std::vector<Reliability*> variables_;
  double time_s_ = 60;
};

}  // namespace galilean::robot
