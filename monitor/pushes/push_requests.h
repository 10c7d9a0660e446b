// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "bhdl/program/program.h"
#include "core/result.h"
#include "core/wire/messages.h"
#include "monitor/pushes/push_order.h"
#include "monitor/pushes/push_record.h"
#include "monitor/pushes/target_check.h"
#include "monitor/trial/figures.h"

namespace galilean::monitor {

// What a push asks for. It goes on with what comes of it, where a result is named.

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
  std::vector<std::string> robots;  ///< the first of them says what runs
  TrialWish wish;
};
/// End the trial: nobody waits for it any more.
struct EndTrial {};
/// Send the program to the robots that the message names. → SendFailed, if it fails
struct SendProgram {
  msg::ProgramPush push;
  bool is_for_team = false;  ///< it is what the team is meant to run from now on
};
/// Order a robot to take the program off again, for the one that it ran before.
struct RollBack {
  std::string order_id;
  std::string author;
  std::string robot;
  std::string hash;
  std::string reason;
};
/// Write down what a robot replied.
struct RecordReply {
  RobotReply reply;
};
/// Tell and write down how far the push is.
struct TellProgress {
  PushRecord push;
};
using PushRequest = std::variant<CheckProgram, RecordPush, TryProgram, EndTrial, SendProgram,
                                 RollBack, RecordReply, TellProgress>;

// What comes of it.

struct CheckedProgram {
  std::string hash;
  std::vector<bhdl::SourceFile> files;  ///< with the includes
  std::string replaces_hash;            ///< what each robot is told that it replaces
};
struct ProgramChecked {
  Result<CheckedProgram, TargetCheck> program;  ///< else with the errors
};
struct PushRecorded {
  Result<void> outcome;
};
struct ProgramTried {
  Result<TrialFigures> figures;
};
struct SendFailed {};
/// This machine could not carry out what was asked for.
struct RequestFailed {
  std::string why;
};
using PushResult =
    std::variant<ProgramChecked, PushRecorded, ProgramTried, SendFailed, RequestFailed>;

}  // namespace galilean::monitor
