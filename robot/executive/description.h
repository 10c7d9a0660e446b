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
    /// Nothing in the program writes it: it is a parameter, whose value is the text's.
    bool parameter = false;
  };
  struct ForceLabel {
    std::string schema;      ///< the motor schema's name
    std::string variable;    ///< the force that it writes
    double gain = 1;         ///< that the schema which combines forces gives to it
    std::size_t runner = 0;  ///< the schema, among all schemas
  };
  struct ImageLabel {
    std::string channel;  ///< the name by which viewers get it
    std::size_t index;    ///< the image, among the images
  };

  ProgramId id = 0;
  bhdl::Program program;
  ProbationRules probation;              ///< which it is under while it is new
  std::vector<VariableLabel> variables;  ///< in the order of the store
  std::vector<std::string> schemas;      ///< perceptual, then motor, in the order of the text
  std::vector<ForceLabel> forces;
  std::vector<ImageLabel> images;  ///< those that schemas show to viewers
};

/// Names of the variables that keep value, status and certainty when `to` takes over from `from`:
/// those of the same name and type, except for the parameters of both.
[[nodiscard]] std::vector<std::string> kept_variables(const Description& from,
                                                      const Description& to);

}  // namespace galilean::robot
