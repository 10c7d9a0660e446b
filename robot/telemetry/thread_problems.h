// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "core/worker.h"
#include "robot/telemetry/words.h"

namespace galilean::robot {

/// The problems that the robot's threads have at the moment. Any thread but the control loop may
/// call it.
class ThreadProblems {
 public:
  /// Returns the report for the worker that the operator knows as `subject`. Requires: this object
  /// outlives the worker.
  [[nodiscard]] Worker::Report reporter(std::string subject);
  /// `sentence` says what is wrong and what to do. An empty sentence removes the problem.
  void note(const std::string& subject, std::string sentence);
  [[nodiscard]] std::vector<Problem> all() const;

 private:
  mutable std::mutex mutex_;
  std::map<std::string, std::string> sentences_;  ///< by subject
};

}  // namespace galilean::robot
