// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "monitor/pushes/history/step.h"

namespace galilean::monitor {

/// The steps of one push in their order: check → try → canary → rest. At most one runs at a time.
class Steps {
 public:
  Steps();

  /// Requires: the step has not begun.
  void leave_out(StepKind kind);
  /// Begins the next step that waits, and returns it; null if none waits.
  const Step* begin_next();
  /// Sets the running step's detail. Does nothing if none runs.
  void describe(const std::string& detail);
  /// Requires: a step runs.
  void finish(const std::string& detail);
  /// Ends the running step as `how`, which is kFailed or kCancelled. Leaves out the steps that
  /// wait.
  void end(StepState how, const std::string& detail);

  [[nodiscard]] bool is_at(StepKind kind) const;
  /// Returns kFailed or kCancelled if a step ended so, kDone once none runs or waits, else
  /// kRunning.
  [[nodiscard]] PushState state() const;
  [[nodiscard]] const std::vector<Step>& all() const noexcept { return steps_; }
  /// Returns a number that grows whenever a step changes.
  [[nodiscard]] unsigned changes() const noexcept { return changes_; }

 private:
  [[nodiscard]] Step* running();
  [[nodiscard]] bool any(StepState state) const;

  std::vector<Step> steps_;
  unsigned changes_ = 0;
};

}  // namespace galilean::monitor
