// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "monitor/pushes/replies.h"
#include "monitor/pushes/step.h"

namespace galilean::monitor {

/// The words for the states of a push, as they stand on the wire, in JSON and in the history: the
/// only place that knows them.
[[nodiscard]] std::string to_text(StepKind kind);
[[nodiscard]] std::string to_text(StepState state);
[[nodiscard]] std::string to_text(PushState state);
[[nodiscard]] std::string to_text(ReplyStatus status);

/// What a word means. Returns nothing for a word that is none of them.
[[nodiscard]] std::optional<StepKind> step_kind_of(std::string_view word);
[[nodiscard]] std::optional<StepState> step_state_of(std::string_view word);
[[nodiscard]] std::optional<PushState> push_state_of(std::string_view word);
[[nodiscard]] std::optional<ReplyStatus> reply_status_of(std::string_view word);

}  // namespace galilean::monitor
