// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "monitor/pushes/history/replies.h"
#include "monitor/pushes/history/step.h"

namespace galilean::monitor {

/// Returns the word for a state of a push on the wire, in JSON and in the history. No other file
/// knows these words.
[[nodiscard]] std::string to_text(StepKind kind);
[[nodiscard]] std::string to_text(StepState state);
[[nodiscard]] std::string to_text(PushState state);
[[nodiscard]] std::string to_text(ReplyStatus status);

/// Returns what a word means; nothing for an unknown word.
[[nodiscard]] std::optional<StepKind> step_kind_of(std::string_view word);
[[nodiscard]] std::optional<StepState> step_state_of(std::string_view word);
[[nodiscard]] std::optional<PushState> push_state_of(std::string_view word);
[[nodiscard]] std::optional<ReplyStatus> reply_status_of(std::string_view word);

}  // namespace galilean::monitor
