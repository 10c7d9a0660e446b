// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "bhdl/program/program.h"
#include "core/result.h"
#include "robot/restart/kept_program.h"

namespace galilean {
struct Catalog;
}

namespace galilean::robot {

/// How the robot program before this one ended.
enum class LastEnd {
  kInOrder,  ///< so it did, or there was none
  kDied,     ///< by a crash, a kill or a loss of power
  kUnknown   ///< what it kept cannot be read
};

/// What a robot program begins with.
struct Start {
  bhdl::Program program;
  bool pushed = false;  ///< a push brought the program to the robot program before
  LastEnd last_end = LastEnd::kInOrder;
  std::string sentence = {};  ///< which program runs and why; empty if there was no choice
  KeptOrders orders = {};     ///< of operators, which hold although the robot program died
};

/// Chooses between the program that was given with --bhdl and the one that was kept. After a death
/// the one that was pushed and confirmed last runs again, because the operators rely on it: it is
/// what the page shows and what the rest of the team runs. After an orderly end, if nobody had
/// pushed it, or if `fresh`, the given one runs. Requires: the given one was checked.
[[nodiscard]] Start choose_start(bhdl::Program given,
                                 const Result<std::optional<KeptProgram>>& kept,
                                 const Catalog& catalog, bool fresh);

}  // namespace galilean::robot
