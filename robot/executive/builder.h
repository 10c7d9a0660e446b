// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "core/catalog/registry.h"
#include "core/result.h"
#include "robot/executive/running_program.h"

namespace galilean {
struct Devices;
}

namespace galilean::robot {

/// What a program is built from.
struct BuildMaterial {
  const Registry& components;
  const Devices& devices;  ///< must outlive the program
  Random random;           ///< each schema gets the child stream of its own name
  ProbationRules probation = {};
};

/// Makes the variables and schemas of a checked program and looks up all its names, so that the
/// tick looks up none. Any thread may call it while another program runs. Errors: the program was
/// checked against another catalog than that of `components`, or it has more variables or forces
/// than a snapshot holds. The error names the component or the limit.
[[nodiscard]] Result<std::unique_ptr<RunningProgram>> build(bhdl::Program program, ProgramId id,
                                                            const BuildMaterial& material);

}  // namespace galilean::robot
