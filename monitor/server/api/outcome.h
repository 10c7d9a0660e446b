// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "monitor/pushes/refusal.h"

namespace galilean::monitor {

/// What an operation comes to: an HTTP status and its JSON; of a failure, `detail` says why in one
/// sentence and `json` has what goes with it.
struct Outcome {
  int status = 200;
  nlohmann::json json = nlohmann::json::object();
  std::string detail = {};
};
using Finish = std::function<void(Outcome)>;

/// For a Worker's job that somebody waits for: 503 with what stood against it.
[[nodiscard]] inline std::function<void(const std::string& why)> unable(Finish finish) {
  return [finish = std::move(finish)](const std::string& why) {
    finish({503, {}, "The monitor cannot do this now: " + why + "."});
  };
}

[[nodiscard]] Outcome outcome_of(const Refusal& refusal);
/// Of an order: 202 while the push is under way.
[[nodiscard]] Outcome outcome_of_order(const PushAnswer& answer);
/// Of a question about a push that there is.
[[nodiscard]] Outcome outcome_of(const PushAnswer& answer);

}  // namespace galilean::monitor
