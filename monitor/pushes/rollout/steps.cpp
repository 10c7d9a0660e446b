// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/rollout/steps.h"

#include <algorithm>

namespace galilean::monitor {

Steps::Steps()
    : steps_{{.kind = StepKind::kCheck},
             {.kind = StepKind::kTry},
             {.kind = StepKind::kCanary},
             {.kind = StepKind::kRest}} {}

void Steps::leave_out(StepKind kind) {
  for (auto& step : steps_)
    if (step.kind == kind) step.state = StepState::kLeftOut;
}

const Step* Steps::begin_next() {
  ++changes_;
  const auto next = std::ranges::find(steps_, StepState::kWaiting, &Step::state);
  if (next == steps_.end()) return nullptr;
  next->state = StepState::kRunning;
  return &*next;
}

void Steps::describe(const std::string& detail) {
  Step* step = running();
  if (!step || step->detail == detail) return;
  step->detail = detail;
  ++changes_;
}

void Steps::finish(const std::string& detail) {
  Step* step = running();
  step->state = StepState::kDone;
  step->detail = detail;
  ++changes_;
}

void Steps::end(StepState how, const std::string& detail) {
  if (Step* step = running()) *step = {step->kind, how, detail};
  for (auto& step : steps_)
    if (step.state == StepState::kWaiting) step.state = StepState::kLeftOut;
  ++changes_;
}

Step* Steps::running() {
  const auto found = std::ranges::find(steps_, StepState::kRunning, &Step::state);
  return found == steps_.end() ? nullptr : &*found;
}

bool Steps::any(StepState state) const {
  return std::ranges::find(steps_, state, &Step::state) != steps_.end();
}

bool Steps::is_at(StepKind kind) const {
  return std::ranges::any_of(steps_, [kind](const Step& step) {
    return step.kind == kind && step.state == StepState::kRunning;
  });
}

PushState Steps::state() const {
  if (any(StepState::kFailed)) return PushState::kFailed;
  if (any(StepState::kCancelled)) return PushState::kCancelled;
  const bool goes_on = any(StepState::kRunning) || any(StepState::kWaiting);
  return goes_on ? PushState::kRunning : PushState::kDone;
}

}  // namespace galilean::monitor
