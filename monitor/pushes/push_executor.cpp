// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/push_executor.h"

#include <boost/asio/post.hpp>
#include <iostream>
#include <utility>

#include "core/wire/ros_time.h"
#include "core/wire/topic_names.h"
#include "monitor/pushes/history/push_messages.h"

namespace galilean::monitor {
namespace {

void log_failure(const Result<void>& outcome) {
  if (!outcome) std::clog << "galilean-monitor: " << outcome.error().message << std::endl;
}

}  // namespace

PushExecutor::PushExecutor(const Parts& parts, wire::Participant& participant, Report report)
    : parts_(parts),
      report_(std::move(report)),
      pushes_(participant, wire::kProgramPushTopic, parts.signer),
      rollbacks_(participant, wire::kProgramRollbackTopic, parts.signer),
      progress_(participant, wire::kPushProgressTopic) {}

Result<void> PushExecutor::carry_out(const std::string& push_id, PushRequest request) {
  return std::visit([&](auto& each) { return carry_out(push_id, std::move(each)); }, request);
}

Result<void> PushExecutor::carry_out(const std::string& push_id, CheckProgram request) {
  const auto asked = std::make_shared<const CheckProgram>(std::move(request));
  const bool is_taken = parts_.checks.offer(
      [asked, &library = parts_.library] {
        return check_for(asked->files, asked->robots, library);
      },
      [this, push_id, asked](TargetCheck check) {
        if (!check.result.program) return report_(push_id, ProgramChecked{std::move(check)});
        auto& program = *check.result.program;
        report_(push_id, ProgramChecked{CheckedProgram{
                             std::move(program.hash), std::move(program.files),
                             replaced_by_each(asked->replaces, asked->robots, parts_.team),
                             std::move(check.taken)}});
      },
      [this, push_id](const std::string& why) {
        report_(push_id, RequestFailed{why + "; nothing was pushed"});
      });
  if (is_taken) return {};
  boost::asio::post(parts_.io, [this, push_id] {
    report_(push_id, RequestFailed{"more programs wait to be checked than the monitor keeps; "
                                   "push again in a moment; nothing was pushed"});
  });
  return {};
}

Result<void> PushExecutor::carry_out(const std::string& push_id, RecordPush request) {
  parts_.worker.run(
      [this, request = std::move(request)] {
        return parts_.history.add(request.push, request.progress);
      },
      [this, push_id](Result<void> outcome) {
        log_failure(outcome);
        report_(push_id, PushRecorded{std::move(outcome)});
      },
      [this, push_id](const std::string& why) {
        report_(push_id, RequestFailed{why + "; nothing was pushed"});
      });
  return {};
}

Result<void> PushExecutor::carry_out(const std::string& push_id, TryProgram request) {
  auto trial = parts_.trials.begin(
      push_id, request, [this, push_id](const auto& figures) { finish_trial(push_id, figures); });
  if (!trial) return trial.error();
  trials_[push_id] = std::move(trial).value();
  return {};
}

void PushExecutor::finish_trial(const std::string& push_id, const Result<TrialFigures>& figures) {
  auto over = trials_.extract(push_id);
  // The trial is running this callback, so it is destroyed later.
  boost::asio::post(parts_.io, [trial = std::shared_ptr<Trial>(std::move(over.mapped()))] {});
  report_(push_id, ProgramTried{figures});
}

Result<void> PushExecutor::carry_out(const std::string& push_id, EndTrial /*request*/) {
  trials_.erase(push_id);
  return {};
}

const Trial* PushExecutor::trial(const std::string& push_id) const {
  const auto found = trials_.find(push_id);
  return found == trials_.end() ? nullptr : found->second.get();
}

Result<void> PushExecutor::carry_out(const std::string& push_id, SendProgram request) {
  if (request.is_for_team) parts_.team.note_push(request.push.hash);
  // What is sent must be known after this process was killed, so that what the robots tell of it
  // then is understood.
  parts_.worker.run(
      [this, push_id, request = std::move(request)]() -> Result<bool> {
        if (const auto kept =
                parts_.history.add_sending(push_id, request.progress, request.awaited);
            !kept)
          return kept.error();
        return pushes_.write(request.push);
      },
      [this, push_id](const Result<bool>& sent) {
        if (!sent)
          report_(push_id, RequestFailed{sent.error().message + "; the program was not sent"});
        else if (!sent.value())
          report_(push_id, SendFailed{});
      },
      [this, push_id](const std::string& why) { report_(push_id, RequestFailed{why}); });
  return {};
}

// The order needs no program, because the robot has kept the one that it ran before. The robot
// replies to the order.
Result<void> PushExecutor::carry_out(const std::string& /*push_id*/, RollBack request) {
  msg::ProgramRollback order;
  order.stamp = wire::ros_time(wire::wall_clock_ns());
  order.id = request.order_id;
  order.author = request.author;
  order.targets = {request.robot};
  order.hash = request.hash;
  order.reason = request.reason;
  const auto warn = [robot = request.robot] {
    std::clog << "galilean-monitor: DDS did not accept the order to " << robot
              << " to go back to its previous program; push the program that it is to run\n";
  };
  parts_.worker.run([this, order] { return rollbacks_.write(order); },
                    [warn](bool taken) {
                      if (!taken) warn();
                    },
                    [warn](const std::string& /*why*/) { warn(); });
  return {};
}

Result<void> PushExecutor::carry_out(const std::string& push_id, RecordReply request) {
  parts_.worker.run([this, push_id, reply = std::move(request.reply)] {
    log_failure(parts_.history.add_reply(push_id, reply));
  });
  return {};
}

Result<void> PushExecutor::carry_out(const std::string& push_id, TellProgress request) {
  parts_.worker.run([this, push_id, message = progress_message(request.push),
                     progress = std::move(request.push.progress)] {
    log_failure(parts_.history.set_progress(push_id, progress));
    (void)progress_.write(message);
  });
  return {};
}

void PushExecutor::publish(const PushRecord& push) {
  parts_.worker.run([this, message = progress_message(push)] { (void)progress_.write(message); });
}

}  // namespace galilean::monitor
