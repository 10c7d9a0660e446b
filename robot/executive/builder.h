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
  Random random;           ///< each schema gets the child that is named as it is
  ProbationRules probation = {};
};

/// Makes the variables and schemas of a checked program and looks all its names up, so that the
/// tick needs none of them. Safe in any thread, beside a program that runs. Fails if `components`
/// is not what the program was checked against, and where the program is beyond what a snapshot
/// holds; the error names the component.
[[nodiscard]] Result<std::unique_ptr<RunningProgram>> build(bhdl::Program program, ProgramId id,
                                                            const BuildMaterial& material);

}  // namespace galilean::robot
