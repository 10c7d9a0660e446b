// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/clock.h"
#include "core/geometry.h"
#include "monitor/top/model/dashboard_model.h"

namespace galilean::monitor::top {

enum class AlarmKind : std::uint8_t {
  kSilent,
  kLate,
  kDrift,
  kStuck,
  kUncertain,
  kProblem,
  kPush,
  kRefused,
  kLost
};

/// What an operator must hear of. The page has the same alarms: web/src/model/alarms.ts.
struct Alarm {
  std::string key;  ///< the same as long as it is the same alarm
  AlarmKind kind = AlarmKind::kProblem;
  std::string robot;      ///< of messages that were not taken: the name in their topic
  std::string words;      ///< one sentence without its full stop
  std::string past = {};  ///< the words once it is over, before how long it lasted; empty: none
  std::optional<Time> since = {};  ///< none: since it was found
};

/// Finds alarms. It remembers since when each robot stands and when a tick was late.
class AlarmFinder {
 public:
  /// Returns what is wrong now. Call it some times a second.
  [[nodiscard]] std::vector<Alarm> find(const DashboardModel& model, Time now);

 private:
  struct Memory {
    std::uint32_t overruns = 0;
    std::optional<Time> late;
    std::optional<Pose2> stands_at;
    Time stands_since{};
  };

  void remember(Memory& memory, const msg::RobotState& state, Time now) const;
  void find_of(const Robot& robot, const DashboardModel& model, Time now,
               std::vector<Alarm>& alarms);

  std::string team_hash_;  ///< of the program that the team runs
  std::map<std::string, Memory> memories_;
};

/// An alarm on the board.
struct PostedAlarm {
  Alarm alarm;
  Time since{};
  std::optional<Time> over = {};
  bool seen = false;
  Time found{};
};

/// The alarms that last, and those that are over and that nobody has seen yet. Those that nobody
/// has seen come first, the newest first.
class AlarmBoard {
 public:
  void update(const std::vector<Alarm>& active, Time now);
  /// Marks the alarms of these keys as seen; all of them if there are no keys.
  void acknowledge(const std::vector<std::string>& keys = {});
  [[nodiscard]] const std::vector<PostedAlarm>& posted() const noexcept { return posted_; }

 private:
  std::vector<PostedAlarm> posted_;
};

/// Returns how long something lasted: "0.4 s", "12 s", "3 min", "2 h".
[[nodiscard]] std::string lasting(double duration_s);
/// Returns "io is silent, for 12 s", "io was silent for 12 s", or "io refused office, 12 s ago".
[[nodiscard]] std::string sentence_of(const PostedAlarm& posted, Time now);

/// Alarms that are shown in one line.
struct AlarmLine {
  std::string text;
  bool seen = false;
  bool over = false;
  std::vector<std::string> keys = {};
  std::string robot = {};  ///< the robot of an alarm that stands alone
};
/// Returns a line for each alarm, or, if there are more than `most`, one for each kind with the
/// robots' names.
[[nodiscard]] std::vector<AlarmLine> alarm_lines(const std::vector<PostedAlarm>& posted, Time now,
                                                 std::size_t most);

}  // namespace galilean::monitor::top
