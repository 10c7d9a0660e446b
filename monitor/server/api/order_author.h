// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "monitor/access/operator_id.h"

namespace galilean::monitor {

/// Returns who gave an order, as the history keeps it and robots are told it. `said` is the
/// request's "author". Where that says nothing, or "operator", which may have a reason in brackets
/// behind it, the sender's name takes its place. `said` is what the sender chose: beside a name
/// that is not that of the sender's own token, the token's name is told, too.
[[nodiscard]] std::string author_of(const std::string& said, const OperatorId& sender);

}  // namespace galilean::monitor
