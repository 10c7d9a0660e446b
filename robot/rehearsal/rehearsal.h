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
  std::vector<Failure> failures;         ///< none: it passed
  std::vector<std::string> transitions;  ///< the start and the last of them, in words

  [[nodiscard]] bool passed() const noexcept { return failures.empty(); }
};

/// The robot's components and what rehearsals need besides.
[[nodiscard]] const Registry& rehearsal_components();

/// Runs a program as one of its expectations wants it: by the real executive at 20 ticks a second
/// of a stepped clock, on devices that stand still, as fast as it goes. The same every time.
[[nodiscard]] ExpectationOutcome rehearse(const bhdl::Program& program,
                                          const bhdl::Expectation& expectation);

/// `file:line:column: failed: "name": …` for each failure, with the last transitions; or one line
/// that says that it passed. With a final newline.
[[nodiscard]] std::string in_words(const ExpectationOutcome& verdict);
void to_json(nlohmann::json& json, const ExpectationOutcome& verdict);

}  // namespace galilean::robot
