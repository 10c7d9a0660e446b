// SPDX-License-Identifier: BSD-3-Clause
#include "robot/telemetry/program_receiver.h"

#include <utility>

#include "bhdl/source/sha256.h"
#include "core/failure.h"
#include "core/wire/reader.h"
#include "core/wire/topic_names.h"
#include "robot/executive/turn.h"
#include "robot/log/log.h"
#include "robot/telemetry/targets.h"

namespace galilean::robot {
namespace {

namespace status = msg::ProgramReply_Constants;

std::vector<bhdl::SourceFile> files_of(const msg::ProgramPush& push) {
  std::vector<bhdl::SourceFile> files;
  for (const auto& file : push.files) files.push_back({file.path, file.text});
  return files;
}

std::vector<msg::Diagnostic> to_messages(const std::vector<bhdl::Diagnostic>& diagnostics) {
  std::vector<msg::Diagnostic> messages;
  for (const auto& diagnostic : diagnostics) {
    msg::Diagnostic& message = messages.emplace_back();
    message.file = diagnostic.file;
    message.line = static_cast<std::uint32_t>(diagnostic.line);
    message.column = static_cast<std::uint32_t>(diagnostic.column);
    message.severity = to_string(diagnostic.severity);
    message.code = diagnostic.code;
    message.message = diagnostic.message;
    message.hint = diagnostic.hint;
  }
  return messages;
}

constexpr float kLongestProbation_s = 3600;

/// Returns why a push's rules of probation are not valid, or an empty text if they are.
std::string objection_to_rules(const msg::ProgramPush& push) {
  if (!(push.probation_s >= 0 && push.probation_s <= kLongestProbation_s))
    return "its probation must last from 0 to 3600 s, not " + std::to_string(push.probation_s);
  if (push.most_transitions_per_s > ProbationRules::kMostCounted)
    return "its limit must be at most " + std::to_string(ProbationRules::kMostCounted) +
           " transitions a second, not " + std::to_string(push.most_transitions_per_s);
  return {};
}

/// Returns the push's rules. Where it says nothing, the robot's own rules apply.
ProbationRules rules_of(const msg::ProgramPush& push, ProbationRules rules) {
  if (push.probation_s > 0) rules.length = from_seconds(push.probation_s);
  if (push.most_transitions_per_s > 0)
    rules.most_transitions_per_s = static_cast<int>(push.most_transitions_per_s);
  return rules;
}

}  // namespace

ProgramReceiver::ProgramReceiver(const TelemetrySource& source, Worker::Report report)
    : source_(source),
      vocabulary_(source.catalog),
      ledger_(source.executive),
      replies_(source.participant, wire::robot_topic(source.robot, "program_reply")),
      pushes_(source.participant, wire::kProgramPushTopic, msg::ProgramPush::kRosType),
      rollbacks_(source.participant, wire::kProgramRollbackTopic, msg::ProgramRollback::kRosType) {
  const auto note_arrival = [this] {
    const std::lock_guard lock(mutex_);
    arrived_ = true;
    wake_.notify_one();
  };
  pushes_.on_data(note_arrival);
  rollbacks_.on_data(note_arrival);
  worker_ = Worker([this](const std::stop_token& stop) { wait_and_take(stop); }, std::move(report));
}

void ProgramReceiver::wait_and_take(const std::stop_token& stop) {
  {
    std::unique_lock lock(mutex_);
    if (!wake_.wait(lock, stop, [this] { return std::exchange(arrived_, false); })) return;
  }
  // Pushes are taken first, because the rollback of a push that is cancelled at once follows it.
  take_from<msg::ProgramPush>(pushes_);
  take_from<msg::ProgramRollback>(rollbacks_);
}

template <class M>
void ProgramReceiver::take_from(wire::Reader& reader) {
  reader.take([this, &reader](const wire::Received& received) {
    M message;
    if (!msg::decode_cdr(received.cdr, message)) return;
    if (!is_meant(source_.robot, message.targets)) return;
    if (message.targets.empty() && !source_.executive.in_service()) return;
    std::string why = source_.accepted_senders.objection(reader.sender(received));
    if (why.empty()) why = handle_or_fail(message);
    if (!why.empty()) reject({message.id, message.hash, {}}, std::move(why));
  });
}

template <class M>
std::string ProgramReceiver::handle_or_fail(const M& message) {
  const std::string failure = failure_of([&] { handle(message); });
  return failure.empty() ? "" : "this robot could not handle it: " + failure;
}

void ProgramReceiver::handle(const msg::ProgramRollback& message) {
  const PushLedger::Push order{message.id, message.hash, {}};
  log_info(message.author + " ordered a rollback of program " + message.hash.substr(0, 8));
  wait_until_runs(message.hash);
  if (auto why = ledger_.roll_back(order, "by " + message.author + ": " + message.reason))
    reject(order, std::move(*why));
}

/// Waits up to 200 ms for a program that was pushed just now, whose first tick may still be to
/// come, or the news of it.
void ProgramReceiver::wait_until_runs(const std::string& hash) const {
  constexpr auto kPatience = std::chrono::milliseconds(200);
  constexpr auto kPause = std::chrono::milliseconds(1);
  for (auto waited = kPause; ledger_.running().hash() != hash && waited < kPatience;
       waited += kPause)
    std::this_thread::sleep_for(kPause);
}

void ProgramReceiver::handle(const msg::ProgramPush& message) {
  PushLedger::Push push{message.id, message.hash, {}};
  auto files = files_of(message);
  if (std::string why = objection(message, files); !why.empty())
    return reject(push, std::move(why));
  log_info(message.author + " pushed program " + files.front().path + " (" +
           push.hash.substr(0, 8) + ")");
  send({.id = push.id,
        .hash = push.hash,
        .running_hash = ledger_.running().hash(),
        .status = status::RECEIVED});
  auto checked = bhdl::check(std::move(files), vocabulary_);
  if (!checked.program)
    return reject(push, "the program has errors", to_messages(checked.diagnostics));
  push.warnings = to_messages(checked.diagnostics);
  run_program(std::move(*checked.program), rules_of(message, source_.executive.probation_rules()),
              std::move(push));
}

std::string ProgramReceiver::objection(const msg::ProgramPush& push,
                                       const std::vector<bhdl::SourceFile>& files) const {
  if (files.empty()) return "the push contains no file";
  if (bhdl::program_hash(files) != push.hash)
    return "its hash does not match its files: they were changed on the way";
  const std::string running = ledger_.running().hash();
  if (!push.replaces_hash.empty() && push.replaces_hash != running)
    return "it is meant to replace program " + push.replaces_hash + ", but program " + running +
           " runs";
  return objection_to_rules(push);
}

void ProgramReceiver::run_program(bhdl::Program program, const ProbationRules& rules,
                                  PushLedger::Push push) {
  if (!wait_for_turn(source_.executive)) return reject(push, "the control loop stands still");
  if (ledger_.running().hash() == push.hash) {
    for (auto& reply : ledger_.join_running(std::move(push))) send(std::move(reply));
    return;
  }
  const auto loaded = ledger_.load(std::move(program), rules, push);
  if (!loaded) reject(push, loaded.error().message);
}

void ProgramReceiver::on_event(const Event& event) {
  for (auto& reply : ledger_.answers(event)) send(std::move(reply));
}

void ProgramReceiver::reject(const PushLedger::Push& push, std::string why,
                             std::vector<msg::Diagnostic> diagnostics) {
  log_warning("program " + push.hash.substr(0, 8) + " was rejected: " + why);
  send({.id = push.id,
        .hash = push.hash,
        .running_hash = ledger_.running().hash(),
        .status = status::REJECTED,
        .message = std::move(why),
        .diagnostics = std::move(diagnostics)});
}

void ProgramReceiver::send(msg::ProgramReply reply) {
  reply.stamp = WallTime::now();
  reply.robot = source_.robot;
  if (!replies_.write(reply))
    log_warning("the answer to push " + reply.id +
                " could not be sent, because DDS did not accept it");
}

}  // namespace galilean::robot
