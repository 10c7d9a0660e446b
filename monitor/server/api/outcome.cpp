// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/api/outcome.h"

#include "monitor/pushes/history/json.h"

namespace galilean::monitor {
namespace {

int status_of(Refusal::Reason reason) {
  switch (reason) {
    case Refusal::Reason::kNotFound:
      return 404;
    case Refusal::Reason::kConflict:
      return 409;
    case Refusal::Reason::kBroken:
      return 422;
    case Refusal::Reason::kUnavailable:
      return 503;
  }
  return 500;
}

}  // namespace

Outcome outcome_of(const Refusal& refusal) {
  return {status_of(refusal.reason), to_json(refusal), refusal.message};
}

Outcome outcome_of_order(const PushAnswer& answer) {
  auto outcome = outcome_of(answer);
  if (answer && answer.value().progress.state == PushState::kRunning) outcome.status = 202;
  return outcome;
}

Outcome outcome_of(const PushAnswer& answer) {
  if (!answer) return outcome_of(answer.error());
  return {200, to_json(answer.value())};
}

}  // namespace galilean::monitor
