// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "monitor/pushes/refusal.h"

namespace galilean::monitor {

/// The result of an operation: an HTTP status and its JSON. If it failed, `detail` says why in one
/// sentence, and `json` holds further members of the answer.
struct Outcome {
  int status = 200;
  nlohmann::json json = nlohmann::json::object();
  std::string detail = {};
};
using Finish = std::function<void(Outcome)>;

/// Returns a failure handler for a Worker's job, which failed by a fault of the monitor's own. It
/// finishes with 500 and the reason.
[[nodiscard]] inline std::function<void(const std::string& why)> failed(Finish finish) {
  return [finish = std::move(finish)](const std::string& why) {
    finish({500, {}, "The monitor failed at this request: " + why + "."});
  };
}
/// Returns the outcome of a request for which there is no room among those that wait.
[[nodiscard]] inline Outcome busy() {
  return {
      503, {}, "More requests of this kind wait than the monitor keeps; ask again in a moment."};
}

[[nodiscard]] Outcome outcome_of(const Refusal& refusal);
/// Returns the outcome of an order to push: 202 while the push is under way, else 200 or a failure.
[[nodiscard]] Outcome outcome_of_order(const PushAnswer& answer);
/// Returns the outcome of a question about a push: 200 or a failure.
[[nodiscard]] Outcome outcome_of(const PushAnswer& answer);

}  // namespace galilean::monitor
