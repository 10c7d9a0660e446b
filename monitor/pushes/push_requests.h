// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "bhdl/program/program.h"
#include "core/result.h"
#include "core/wire/messages.h"
#include "monitor/pushes/history/push_record.h"
#include "monitor/pushes/push_order.h"
#include "monitor/pushes/target_check.h"
#include "monitor/trial/figures.h"

namespace galilean::monitor {

// The requests of a push. An arrow names the result with which the push goes on, if there is one.

/// Check the program against each robot's catalog. → ProgramChecked
struct CheckProgram {
  std::vector<bhdl::SourceFile> files;
  std::vector<Target> robots;
  std::string replaces;  ///< the hash that the order names
};
/// Write the push into the history, before anything of it is sent. → PushRecorded
struct RecordPush {
  msg::ProgramPush push;
  Progress progress;
};
/// Try the program in simulation, beside the one that runs. → ProgramTried
struct TryProgram {
  std::vector<bhdl::SourceFile> files;
  std::vector<std::string> robots;  ///< the first one whose program is known says what runs
  TrialOptions options;
};
/// End the trial, because the push has ended before it.
struct EndTrial {};
/// Write into the history which robots are to run the program, then send it to those that the
/// message names. → SendFailed or RequestFailed, if it fails
struct SendProgram {
  msg::ProgramPush push;
  std::vector<std::string> awaited = {};  ///< the robots that must reply
  Progress progress = {};                 ///< how far the push is with it
  bool is_for_team = false;               ///< the team is meant to run this program from now on
};
/// Order a robot to go back from the program to the one that it ran before.
struct RollBack {
  std::string order_id;
  std::string author;
  std::string robot;
  std::string hash;
  std::string reason;
};
/// Write a robot's reply into the history.
struct RecordReply {
  RobotReply reply;
};
/// Write into the history how far the push is, and publish it.
struct TellProgress {
  PushRecord push;
};
using PushRequest = std::variant<CheckProgram, RecordPush, TryProgram, EndTrial, SendProgram,
                                 RollBack, RecordReply, TellProgress>;

// The results of requests.

struct CheckedProgram {
  std::string hash;
  std::vector<bhdl::SourceFile> files;  ///< the main file first, then the files that it includes
  std::string replaces_hash;            ///< for ProgramPush::replaces_hash; may be empty
  std::vector<TakenFile> taken = {};    ///< files that were not sent, and came from the library
};
struct ProgramChecked {
  Result<CheckedProgram, TargetCheck> program;  ///< or the check with the program's errors
};
struct PushRecorded {
  Result<void> outcome;
};
struct ProgramTried {
  Result<TrialFigures> figures;
};
struct SendFailed {};
/// This machine could not carry a request out.
struct RequestFailed {
  std::string why;
};
using PushResult =
    std::variant<ProgramChecked, PushRecorded, ProgramTried, SendFailed, RequestFailed>;

}  // namespace galilean::monitor
