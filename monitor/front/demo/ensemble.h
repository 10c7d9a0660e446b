// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <filesystem>
#include <string>
#include <vector>

#include "core/result.h"
#include "core/termination.h"
#include "monitor/front/demo/options.h"
#include "monitor/front/process.h"

namespace galilean::front {

/// A simulator, its robots and a monitor (and a recorder), each a process of its own with a log of
/// its own. All of them end with this object.
class Ensemble {
 public:
  /// `termination`: starting stops when it is asked.
  Ensemble(const DemoOptions& options, Termination& termination);
  ~Ensemble();
  Ensemble(const Ensemble&) = delete;
  Ensemble& operator=(const Ensemble&) = delete;

  /// Returns when the monitor answers; the reason if something did not start.
  [[nodiscard]] std::optional<Error> start();

  struct Loss {
    std::string name, ending, log_end;
    std::filesystem::path log;
    bool fatal = false;  ///< nothing works without it
  };
  /// Those that ended since the last call, unasked.
  [[nodiscard]] std::vector<Loss> losses();
  /// Ends all in order, the recorder first. A sentence for each that would not.
  [[nodiscard]] std::vector<std::string> end();

  [[nodiscard]] const std::vector<std::string>& robots() const noexcept { return robot_names_; }
  [[nodiscard]] const std::filesystem::path& logs() const noexcept { return logs_; }
  /// The page's address, with the token that lets its reader steer the team.
  [[nodiscard]] std::string operator_link() const;

 private:
  struct Member {
    Process process;
    bool fatal;
    bool lost = false;
  };
  [[nodiscard]] std::optional<Error> start_simulator();
  [[nodiscard]] std::optional<Error> start_robots(const std::string& ready_line);
  [[nodiscard]] std::optional<Error> start_monitor();
  [[nodiscard]] std::optional<Error> start_recorder();
  [[nodiscard]] std::optional<Error> add(std::string name, std::vector<std::string> command,
                                         bool fatal);
  /// The first line of the newest member's log with `mark`, as soon as it is there.
  [[nodiscard]] Result<std::string> await_line(std::string_view mark);
  void sweep() const;

  DemoOptions options_;
  Termination& termination_;
  std::filesystem::path logs_;
  std::string run_;
  std::vector<std::string> robot_names_;
  std::vector<std::string> starts_;  ///< for the map: ROBOT:X,Y,HEADING in m and degrees
  std::vector<std::string> rings_;   ///< names of the cameras' shared memory
  std::filesystem::path lines_;      ///< the folder of the serial lines
  std::deque<Member> members_;       ///< in the order of starting
};

}  // namespace galilean::front
