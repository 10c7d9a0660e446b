// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "monitor/expect/judge/belief.h"
#include "monitor/expect/judge/monitor.h"

namespace galilean::expect {

/// Watches one claim for one robot, or for the team: evaluates the claim's conditions whenever they
/// may change, and gives what they are to its monitor.
class ClaimWatch {
 public:
  /// Requires: the claim is about conditions. Both references outlive this.
  ClaimWatch(const Claim& claim, const Belief& belief);

  /// Sets what is called with the instant and what was so then, whenever the claim fails.
  void on_failure(std::function<void(std::int64_t, const std::string&)> call) {
    monitor_->on_failure = std::move(call);
  }
  [[nodiscard]] unsigned sources() const noexcept { return sources_; }
  /// Takes what changes with time alone, up to `at_ns`. Call it before the belief changes.
  void advance(std::int64_t at_ns);
  /// Takes what the belief now is. Call it after the belief changed.
  void observe(std::int64_t at_ns);
  [[nodiscard]] Finding finish(std::int64_t end_ns);

 private:
  const Belief& belief_;
  const Condition* first_ = nullptr;
  const Condition* second_ = nullptr;
  unsigned sources_;
  std::unique_ptr<Monitor> monitor_;
  std::int64_t last_ns_ = 0;
  bool begun_ = false;
  std::vector<std::int64_t> changes_;  ///< kept for its memory
};

}  // namespace galilean::expect
