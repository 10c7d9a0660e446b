// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/history/words.h"

#include <array>
#include <utility>

namespace galilean::monitor {
namespace {

template <class Enum, std::size_t N>
using Words = std::array<std::pair<Enum, std::string_view>, N>;

constexpr Words<StepKind, 4> kStepKinds{{{StepKind::kCheck, "check"},
                                         {StepKind::kTry, "try"},
                                         {StepKind::kCanary, "canary"},
                                         {StepKind::kRest, "rest"}}};

constexpr Words<StepState, 6> kStepStates{{{StepState::kWaiting, "waiting"},
                                           {StepState::kRunning, "running"},
                                           {StepState::kDone, "done"},
                                           {StepState::kFailed, "failed"},
                                           {StepState::kCancelled, "cancelled"},
                                           {StepState::kLeftOut, "left_out"}}};

constexpr Words<PushState, 7> kPushStates{{{PushState::kRunning, "running"},
                                           {PushState::kDone, "done"},
                                           {PushState::kFailed, "failed"},
                                           {PushState::kCancelled, "cancelled"},
                                           {PushState::kInterrupted, "interrupted"},
                                           {PushState::kToldLater, "told_later"},
                                           {PushState::kForeign, ""}}};

constexpr Words<ReplyStatus, 7> kReplyStatuses{{{ReplyStatus::kNoAnswer, "no_answer"},
                                                {ReplyStatus::kReceived, "received"},
                                                {ReplyStatus::kRejected, "rejected"},
                                                {ReplyStatus::kRunning, "running"},
                                                {ReplyStatus::kConfirmed, "confirmed"},
                                                {ReplyStatus::kRolledBack, "rolled_back"},
                                                {ReplyStatus::kUnknown, "unknown"}}};

template <class Enum, std::size_t N>
std::string word_for(Enum value, const Words<Enum, N>& words) {
  for (const auto& [each, word] : words)
    if (each == value) return std::string(word);
  return {};
}

template <class Enum, std::size_t N>
std::optional<Enum> meaning_of(std::string_view text, const Words<Enum, N>& words) {
  for (const auto& [each, word] : words)
    if (word == text) return each;
  return std::nullopt;
}

}  // namespace

std::string to_text(StepKind kind) {
  return word_for(kind, kStepKinds);
}

std::string to_text(StepState state) {
  return word_for(state, kStepStates);
}

std::string to_text(PushState state) {
  return word_for(state, kPushStates);
}

std::string to_text(ReplyStatus status) {
  return word_for(status, kReplyStatuses);
}

std::optional<StepKind> step_kind_of(std::string_view word) {
  return meaning_of(word, kStepKinds);
}

std::optional<StepState> step_state_of(std::string_view word) {
  return meaning_of(word, kStepStates);
}

std::optional<PushState> push_state_of(std::string_view word) {
  return meaning_of(word, kPushStates);
}

std::optional<ReplyStatus> reply_status_of(std::string_view word) {
  return meaning_of(word, kReplyStatuses);
}

}  // namespace galilean::monitor
