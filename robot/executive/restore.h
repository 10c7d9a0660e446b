// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "robot/executive/running_program.h"

namespace galilean::robot {

/// A variable as telemetry tells it.
struct VariableSituation {
  std::string name;
  std::string type;          ///< "locate"
  std::string object_class;  ///< of a locate
  bool valid = false;
  double certainty = 0;
  std::vector<double> values;  ///< in the order of a snapshot's
};

/// What a robot's program had come to, in this process or another.
struct Situation {
  std::string state;
  std::vector<VariableSituation> variables;
};

/// As a swap carries variables over: those of the same name and type keep value, status and
/// certainty; constants are the program's own. What does not fit its type is left as it is.
void restore_variables(const Situation& situation, RunningProgram& program, Time now);

}  // namespace galilean::robot
