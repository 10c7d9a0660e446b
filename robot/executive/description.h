// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "bhdl/program/program.h"
#include "robot/executive/probation.h"

namespace galilean::robot {

/// Says what the indices in events and snapshots stand for. It never changes, and so any thread may
/// read it while the program runs.
struct Description {
  struct VariableLabel {
    std::string name;
    std::string type;  ///< "locate"
    /// True if nothing in the program writes the variable: it is a parameter, and the text gives
    /// its value.
    bool parameter = false;
  };
  struct ForceLabel {
    std::string schema;      ///< the motor schema's name
    std::string variable;    ///< the force that it writes
    double gain = 1;         ///< the gain that the schema which combines forces gives to it
    std::size_t runner = 0;  ///< the schema, among all schemas
  };
  struct ImageLabel {
    std::string channel;  ///< the name by which viewers get it
    std::size_t index;    ///< the image, among the images
  };

  ProgramId id = 0;
  bhdl::Program program;
  ProbationRules probation;              ///< the rules of its probation
  std::vector<VariableLabel> variables;  ///< in the order of the store
  std::vector<std::string> schemas;      ///< perceptual, then motor, in the order of the text
  std::vector<ForceLabel> forces;
  std::vector<ImageLabel> images;  ///< the images that schemas show to viewers
};

/// Returns the names of the variables that keep value, status and certainty when `to` takes over
/// from `from`. They have the same name and type in both, and are not parameters of both.
[[nodiscard]] std::vector<std::string> kept_variables(const Description& from,
                                                      const Description& to);

}  // namespace galilean::robot
