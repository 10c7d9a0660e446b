// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "bhdl/program/program.h"
#include "core/catalog/registry.h"

namespace galilean::robot {

/// A claim that did not come true, for the person who wrote it.
struct Failure {
  bhdl::Location location;
  std::string message;
};

/// What became of an expectation.
struct ExpectationOutcome {
  std::string name;
  bhdl::Location location;
  std::vector<Failure> failures;         ///< empty: it passed
  std::vector<std::string> transitions;  ///< the last ones in words, where the start counts as one

  [[nodiscard]] bool passed() const noexcept { return failures.empty(); }
};

/// Returns the robot's components and the schemas that rehearsals add.
[[nodiscard]] const Registry& rehearsal_components();

/// Runs a program as one of its expectations demands. The real executive runs it at 20 ticks a
/// second of a stepped clock, as fast as the machine can, on devices that stand still. The result
/// is the same every time.
[[nodiscard]] ExpectationOutcome rehearse(const bhdl::Program& program,
                                          const bhdl::Expectation& expectation);

/// Returns `file:line:column: failed: name: …` for each failure, then the last transitions, or
/// one line that says that it passed. The text ends with a newline.
[[nodiscard]] std::string in_words(const ExpectationOutcome& verdict);
void to_json(nlohmann::json& json, const ExpectationOutcome& verdict);

}  // namespace galilean::robot
