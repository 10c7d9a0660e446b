// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/result.h"
#include "core/termination.h"
#include "monitor/front/demo/options.h"
#include "monitor/front/demo/recorder_words.h"
#include "monitor/front/demo/recording_check.h"
#include "monitor/front/process.h"

namespace galilean::front {

/// The processes of a demonstration: a simulator, its robots, a monitor and perhaps a recorder.
/// Each has a log of its own. The destructor ends them all.
class Ensemble {
 public:
  /// `start` gives up when `termination` is asked for.
  Ensemble(const DemoOptions& options, Termination& termination);
  ~Ensemble();
  Ensemble(const Ensemble&) = delete;
  Ensemble& operator=(const Ensemble&) = delete;

  /// Starts all, and returns when the monitor serves. Waits at most 30 s, and one more for each
  /// robot, for the simulator and as long for the monitor. Errors: no robot can run the program,
  /// one of the processes did not start, robots of the same names live in the DDS domain, or
  /// termination was asked for.
  Result<void> start();

  struct Loss {
    std::string name, ending, log_end;
    std::filesystem::path log;
    bool fatal = false;  ///< nothing works without this process
  };
  /// Returns the processes that ended by themselves since the last call.
  [[nodiscard]] std::vector<Loss> losses();
  /// Ends all processes in order, the recorder first. Returns a sentence for each one that had to
  /// be killed.
  [[nodiscard]] std::vector<std::string> end();

  [[nodiscard]] const std::vector<std::string>& robots() const noexcept { return robot_names_; }
  [[nodiscard]] const std::filesystem::path& logs() const noexcept { return logs_; }
  /// Prints what came of the expectations. Returns the exit code of `galilean log check`.
  /// Requires: there are expectations, and all processes have ended. Errors: they cannot be judged.
  /// @param problems   what went wrong in the run, which the reports tell, too
  /// @param shortages  why the recording is not whole, which they tell, too
  [[nodiscard]] Result<int> judge_recording(const std::vector<std::string>& problems,
                                            const std::vector<std::string>& shortages) {
    return check_.judge(options_.record, problems, shortages);
  }
  /// Returns what the recorder has said since the last call, a sentence each.
  [[nodiscard]] std::vector<std::string> recorder_said() { return recorder_words_.take(); }
  /// Returns the recorder's exit code, kFailed if it was killed, or 0 without a recorder.
  /// Requires: all processes have ended.
  [[nodiscard]] int recorder_exit_code() const;
  /// Returns the file that is recorded; empty: none is.
  [[nodiscard]] const std::string& recording() const noexcept { return options_.record; }
  /// Writes to JUnit's XML, if it is asked for, why nothing was judged. Errors: that cannot be
  /// done.
  [[nodiscard]] Result<void> give_up(const std::string& why) { return check_.give_up(why); }
  /// Returns the page's address, with the operator's token if that can be read.
  [[nodiscard]] std::string operator_link() const;

 private:
  struct Member {
    Process process;
    bool fatal;
    bool lost = false;
  };
  Result<void> start_simulator();
  /// Notes the robots' names.
  Result<void> name_robots(const std::string& ready_line);
  Result<void> start_robots(const std::string& ready_line);
  Result<void> start_monitor();
  Result<void> start_recorder();
  /// Waits until the recording is there. Errors: as await_line.
  [[nodiscard]] Result<void> await_recording();
  Result<void> add(std::string name, std::vector<std::string> command, bool fatal);
  /// Waits for the first line with `mark` in the log of the process that was started last.
  /// Errors: the process ends, no such line comes in time, or termination is asked for.
  [[nodiscard]] Result<std::string> await_line(std::string_view mark);
  /// Waits until `is_ready()` returns true. Errors: as await_line.
  [[nodiscard]] Result<void> await(Process& process, const std::function<bool()>& is_ready);
  void sweep() const;

  DemoOptions options_;
  Termination& termination_;
  std::filesystem::path logs_;
  RecordingCheck check_;
  RecorderWords recorder_words_;
  std::string run_;
  std::vector<std::string> robot_names_;
  std::vector<std::string> starts_;  ///< the monitor's --start: ROBOT:X,Y,HEADING in m and degrees
  std::vector<std::string> rings_;   ///< names of the cameras' shared memory
  std::filesystem::path lines_;      ///< the folder of the serial lines
  std::deque<Member> members_;       ///< in the order of starting
};

}  // namespace galilean::front
