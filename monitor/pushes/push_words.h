// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "core/wire/messages.h"
#include "monitor/pushes/history.h"
#include "monitor/pushes/outcome.h"
#include "monitor/pushes/push_order.h"
#include "monitor/pushes/target_check.h"

namespace galilean::monitor {

/// Why an order is refused, as problems that name who and what; `pushed` has the other's push.
/// 409: `other` is under way to the same robots.
[[nodiscard]] Outcome conflict(const PushRecord& other);
/// 409: another program runs than the one that was to be replaced. `by`: who pushed it.
[[nodiscard]] Outcome overtaken(const std::string& replaces, const Stale& stale,
                                const std::optional<PushRecord>& by);
/// 422, with the diagnostics.
[[nodiscard]] Outcome broken(const TargetCheck& check);
/// Why it can no longer be cancelled.
[[nodiscard]] std::string too_late(const PushRecord& push);

/// "office_cleanup.bhdl (1a2b3c4d)"
[[nodiscard]] std::string program_words(const PushRecord& push);
[[nodiscard]] msg::PushProgress progress_message(const PushRecord& push);

}  // namespace galilean::monitor
