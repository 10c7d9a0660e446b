// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "monitor/expect/judge/belief.h"
#include "monitor/expect/judge/truth.h"
#include "monitor/expect/language/expectation.h"

namespace galilean::expect {

/// Returns whether the condition holds at an instant, by what is known then. Certainties have
/// decayed since they were told.
[[nodiscard]] Value evaluate(const Condition& condition, const Belief& belief, std::int64_t at_ns);

/// Adds the instants after `after_ns` and before `before_ns` at which the condition's truth may
/// change though nothing is heard: a certainty passes its limit or ends, or a value is too old.
void add_changes(const Condition& condition, const Belief& belief, std::int64_t after_ns,
                 std::int64_t before_ns, std::vector<std::int64_t>& changes);

/// Returns what is known of all that the condition asks about: "state is 'stuck'; certainty of
/// trash is 0.31".
[[nodiscard]] std::string describe(const Condition& condition, const Belief& belief,
                                   std::int64_t at_ns);

/// Returns the unit of the condition's margin, as written first. Returns nothing if it compares no
/// numbers, or numbers of several dimensions.
[[nodiscard]] std::optional<Unit> margin_unit(const Condition& condition);

}  // namespace galilean::expect
