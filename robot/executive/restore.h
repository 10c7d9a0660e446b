// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "robot/executive/running_program.h"

namespace galilean::robot {

/// A variable in the form that telemetry publishes.
struct VariableSituation {
  std::string name;
  std::string type;          ///< "locate"
  std::string object_class;  ///< of a locate
  bool valid = false;
  double certainty = 0;
  std::vector<double> values;  ///< in the order of a snapshot's values
};

/// The state and the variables of a program that ran before, in this process or another.
struct Situation {
  std::string state;
  std::vector<VariableSituation> variables;
};

/// Gives the program's variables the values of `situation`, as a swap does: a variable of the same
/// name and type keeps value, status and certainty. Constants stay the program's own, and a value
/// that does not fit its variable's type is ignored.
void restore_variables(const Situation& situation, RunningProgram& program, Time now);

}  // namespace galilean::robot
