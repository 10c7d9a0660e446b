// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/clock.h"

namespace galilean {

/// Shows on one line of a terminal how much of a task is done, once it has taken a second.
class ProgressBar {
 public:
  static constexpr Duration kQuietFor = std::chrono::seconds(1);
  static constexpr Duration kShowEach = std::chrono::milliseconds(100);

  struct Setup {
    std::string task;                               ///< such as "reading run.mcap"
    const Clock& clock;                             ///< outlives the bar
    std::function<void(const std::string&)> write;  ///< to the terminal, at once
  };
  explicit ProgressBar(Setup setup)
      : setup_(std::move(setup)), next_(setup_.clock.now() + kQuietFor) {}
  ~ProgressBar() { clear(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Takes how much is done, from 0 to 1. Call it as often as you like.
  void show(double done);
  /// Takes the bar away, so that something else can be written.
  void clear();

 private:
  Setup setup_;
  Time next_;
  bool is_shown_ = false;
};

/// Returns a bar on standard error; nothing if that is no terminal that can show one, or if
/// `prints_meanwhile` is true and standard output is a terminal, whose lines it would spoil.
[[nodiscard]] std::unique_ptr<ProgressBar> progress_on_terminal(std::string task,
                                                                bool prints_meanwhile = false);

}  // namespace galilean
