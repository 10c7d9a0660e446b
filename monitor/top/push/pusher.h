// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bhdl/source/source_file.h"
#include "monitor/top/panels/sheet.h"

namespace galilean::monitor::top {

/// What is to be pushed, and to whom.
struct PushWish {
  // The program is that of `file`, else that of `hash`, else the last good one.
  std::string file;                          ///< on this machine
  std::string hash;                          ///< of a program that was pushed before
  std::vector<std::string> robots;           ///< empty: the team
  std::string canary;                        ///< the robot that would run it first; empty: none
  std::string runs_hash;                     ///< of the program that runs now
  std::vector<bhdl::SourceFile> runs;        ///< its text, which the differences are told from
  std::vector<bhdl::SourceFile> files = {};  ///< the program itself, for push_at_once
  std::string reason = {};                   ///< why; it stands beside the author
  std::string replaces = {};                 ///< the hash that the robots must run; empty: any
};

/// How far a push has come.
struct PushReport {
  enum class Stage : std::uint8_t {
    kNone,
    kChecking,
    kRefused,  ///< nothing was pushed
    kReady,    ///< it was checked, and waits for a yes
    kPushing,
    kDone,
    kFailed,
    kUnknown  ///< the monitor stopped answering; whether it was pushed is not known
  };
  Stage stage = Stage::kNone;
  std::string title;
  std::vector<Sheet::Line> lines;
  std::string id = {};  ///< of the push, once the monitor took it
};

/// A push that the monitor remembers.
struct PastPush {
  std::int64_t pushed_ns = 0;  ///< since the Unix epoch
  std::string author;
  std::string program;
  std::string hash;  ///< empty: the program was no valid one
  std::string state;
  bool has_failed = false;
  std::vector<std::string> targets;   ///< empty: the team
  std::vector<std::string> outcomes;  ///< what each robot answered: "io confirmed"
};
/// The pushes that the monitor remembers.
struct PastPushes {
  bool is_known = false;
  std::string trouble;           ///< why they are not known; empty: the answer is under way
  std::vector<PastPush> pushes;  ///< the newest first
};

/// Who steers a robot through the monitor, as it told last.
struct ToldLease {
  std::string holder;  ///< the operator's name
  std::string asker;   ///< who asks the holder for it; empty: nobody
  bool is_yours = false;
  bool is_asked_by_you = false;
};

/// Pushes programs, and takes turns at steering, both through a monitor. No call waits.
class Pusher {
 public:
  virtual ~Pusher() = default;
  /// Returns why nothing can be pushed, in one sentence; empty if it can.
  [[nodiscard]] virtual std::string hindrance() const = 0;
  /// Checks the program and finds how it differs from the one that runs.
  virtual void check(const PushWish& wish) = 0;
  /// Pushes what was checked. Requires: the stage is kReady.
  virtual void push(bool with_canary) = 0;
  /// Pushes `wish.files`, which the monitor checks first. Requires: no push is under way.
  virtual void push_at_once(const PushWish& wish) = 0;
  /// Cancels the push, or forgets what was checked.
  virtual void cancel() = 0;
  [[nodiscard]] virtual PushReport report() const = 0;
  /// Asks for the pushes that the monitor remembers.
  virtual void list() = 0;
  [[nodiscard]] virtual PastPushes pushes() const = 0;
  /// Returns nothing if nobody holds the robot, or if no monitor tells who does.
  [[nodiscard]] virtual std::optional<ToldLease> lease(const std::string& /*robot*/) const {
    return {};
  }
  /// Asks for a robot's lease, or takes, gives or refuses it: "ask", "take", "give" or "refuse".
  virtual void change_lease(const std::string& /*deed*/, const std::string& /*robot*/,
                            const std::string& /*reason*/) {}
  /// Returns once what the monitor answered to a change of a lease that it refused; else an empty
  /// text.
  [[nodiscard]] virtual std::string take_lease_refusal() { return {}; }
};

}  // namespace galilean::monitor::top
