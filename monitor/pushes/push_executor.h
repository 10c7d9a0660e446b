// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/asio/io_context.hpp>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "core/result.h"
#include "core/wire/messages.h"
#include "core/wire/participant.h"
#include "core/wire/writer.h"
#include "monitor/background/worker.h"
#include "monitor/pushes/history.h"
#include "monitor/pushes/push_requests.h"
#include "monitor/pushes/trial_room.h"
#include "monitor/team/team.h"

namespace galilean::monitor {

/// Carries out what pushes ask for: checks, trials, DDS writes, and lines in the history.
///
/// Lives on the io_context's thread; checking, the disk and DDS writes happen on a worker's, one
/// after another, in the order in which they were asked for.
class PushExecutor {
 public:
  struct Parts {
    boost::asio::io_context& io;
    Worker& worker;
    Team& team;
    const ProgramLibrary& library;
    History& history;  ///< the worker's alone
    const TrialRoom& trials;
  };
  /// Is called on the io_context's thread, never from within `carry_out`.
  using Report = std::function<void(const std::string& push_id, const PushResult& result)>;

  PushExecutor(const Parts& parts, wire::Participant& participant, Report report);

  /// Begins what the push asks for; what comes of it is reported. Errors: it could not be begun.
  [[nodiscard]] Result<void> carry_out(const std::string& push_id, PushRequest request);
  /// Returns the push's trial; null where none is under way.
  [[nodiscard]] const Trial* trial(const std::string& push_id) const;

 private:
  Result<void> carry_out(const std::string& push_id, CheckProgram request);
  Result<void> carry_out(const std::string& push_id, RecordPush request);
  Result<void> carry_out(const std::string& push_id, TryProgram request);
  Result<void> carry_out(const std::string& push_id, EndTrial request);
  Result<void> carry_out(const std::string& push_id, SendProgram request);
  Result<void> carry_out(const std::string& push_id, RollBack request);
  Result<void> carry_out(const std::string& push_id, RecordReply request);
  Result<void> carry_out(const std::string& push_id, TellProgress request);
  void finish_trial(const std::string& push_id, const Result<TrialFigures>& figures);

  Parts parts_;
  Report report_;
  wire::Writer<msg::ProgramPush> pushes_;
  wire::Writer<msg::ProgramRollback> rollbacks_;
  wire::Writer<msg::PushProgress> progress_;
  std::map<std::string, std::unique_ptr<Trial>> trials_;  ///< under way, by their pushes' ids
};

}  // namespace galilean::monitor
