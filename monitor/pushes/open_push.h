// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "core/wire/messages.h"
#include "monitor/pushes/history.h"
#include "monitor/pushes/outcome.h"
#include "monitor/pushes/push_order.h"
#include "monitor/trial/trial.h"

namespace galilean::monitor {

/// One push on the desk, with all that its steps need.
struct OpenPush {
  PushRecord record;  ///< without the answers, which `swap` has
  SwapTransaction swap;
  PushOrder order = {};
  OrderTargets targets = {};
  bool is_ours = true;
  msg::ProgramPush message = {};  ///< once it is checked
  Finish finish = nullptr;        ///< who ordered it waits
  unsigned told_version = 0;
  std::string take_back_id = {};           ///< of the order to the canary, once there is one
  std::unique_ptr<Trial> trial = nullptr;  ///< while it is under way

  [[nodiscard]] PushRecord newest() const {
    auto result = record;
    result.progress = {swap.state(), swap.steps(), record.progress.trial_json};
    result.answers = swap.answers();
    return result;
  }
  /// Whoever ordered it waits no more; the first answer counts.
  void answer(Outcome outcome) {
    if (const auto waiting = std::exchange(finish, nullptr)) waiting(std::move(outcome));
  }
};

}  // namespace galilean::monitor
