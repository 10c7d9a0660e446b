// SPDX-License-Identifier: BSD-3-Clause
#include "robot/telemetry/thread_problems.h"

#include <utility>

namespace galilean::robot {

Worker::Report ThreadProblems::reporter(std::string subject) {
  return [this, subject = std::move(subject)](const std::string& failure) {
    note(subject, failure.empty() ? ""
                                  : "It failed (" + failure +
                                        ") and is tried again: if this stays, start the robot "
                                        "again.");
  };
}

void ThreadProblems::note(const std::string& subject, std::string sentence) {
  const std::lock_guard lock(mutex_);
  if (sentence.empty())
    sentences_.erase(subject);
  else
    sentences_[subject] = std::move(sentence);
}

std::vector<Problem> ThreadProblems::all() const {
  const std::lock_guard lock(mutex_);
  std::vector<Problem> problems;
  for (const auto& [subject, sentence] : sentences_) problems.push_back({subject, sentence});
  return problems;
}

}  // namespace galilean::robot
