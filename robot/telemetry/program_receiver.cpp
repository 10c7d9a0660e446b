// SPDX-License-Identifier: BSD-3-Clause
#include "robot/telemetry/program_receiver.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "bhdl/source/sha256.h"
#include "core/cut_text.h"
#include "core/failure.h"
#include "core/wire/reader.h"
#include "core/wire/topic_names.h"
#include "robot/executive/turn.h"
#include "robot/log/log.h"
#include "robot/telemetry/order_words.h"
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

/// An hour, which is the most that an operator can order, and the time in which a monitor decides
/// whether the canary's program is rolled back.
constexpr float kLongestProbation_s = 3610;
constexpr std::size_t kShownOfHash = 8;

void log_rejection(const std::string& hash, const std::string& why) {
  log_warning("program " + std::string(cut_text(hash, kShownOfHash)) + " was rejected: " + why);
}

/// Errors: the push's rules of probation are not valid.
Result<void> check_rules(const msg::ProgramPush& push) {
  if (!(push.probation_s >= 0 && push.probation_s <= kLongestProbation_s))
    return Error{"its probation must last from 0 to 3610 s, not " +
                 std::to_string(push.probation_s)};
  if (push.most_transitions_per_s > ProbationRules::kMostCounted)
    return Error{"its limit must be at most " + std::to_string(ProbationRules::kMostCounted) +
                 " transitions a second, not " + std::to_string(push.most_transitions_per_s)};
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

ProgramReceiver::ProgramReceiver(const TelemetrySource& source, OrderGate& gate,
                                 Worker::Report report)
    : source_(source),
      gate_(gate),
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
  take_from<msg::ProgramPush>(pushes_, wire::kProgramPushTopic);
  take_from<msg::ProgramRollback>(rollbacks_, wire::kProgramRollbackTopic);
}

template <class M>
void ProgramReceiver::take_from(wire::Reader& reader, const std::string& topic) {
  const std::string place = order_place(source_.participant.domain(), topic);
  reader.take([this, &reader, &place](const wire::Received& received) {
    M message;
    if (!msg::decode_cdr(received.cdr, message)) return;
    if (!is_meant(source_.robot, message.targets)) return;
    if (message.targets.empty() && !source_.executive.in_service()) return;
    const OrderGate::Origin origin{
        received.writer, [&reader, writer = received.writer] { return reader.sender(writer); }};
    const PushLedger::Push push{message.id, message.hash, {}};
    if (const auto admitted = gate_.admit(message, place, what_is(message), origin); !admitted)
      return refuse(push, admitted.error());
    if (const auto done = handle_from(origin, message); !done) {
      log_rejection(push.hash, done.error().message);
      write(stamped(rejection(push, done.error().message, {})));
    }
  });
}

template <class M>
Result<void> ProgramReceiver::handle_from(const OrderGate::Origin& origin, const M& message) {
  const auto sender = origin.sender();
  const auto name = sender ? std::optional(sender->name) : std::nullopt;
  if (auto accepted = source_.accepted_senders.accept(name); !accepted) return accepted;
  if (const auto done = attempt([&] { handle(message); }); !done)
    return Error{"this robot could not handle it: " + done.error().message};
  return {};
}

void ProgramReceiver::handle(const msg::ProgramRollback& message) {
  const PushLedger::Push order{message.id, message.hash, {}};
  log_info(message.author + " ordered a rollback of program " +
           std::string(cut_text(message.hash, kShownOfHash)));
  wait_until_runs(message.hash);
  const std::string reason = "by " + message.author + ": " + message.reason;
  if (const auto ordered = ledger_.roll_back(order, reason); !ordered)
    reject(order, ordered.error().message);
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
  // Whoever sends a push twice means one: what has been pushed since then runs on.
  if (answer_again(message)) return;
  PushLedger::Push push{message.id, message.hash, {}};
  auto files = files_of(message);
  if (const auto admitted = admit(message, files); !admitted)
    return reject(push, admitted.error().message);
  log_info(message.author + " pushed program " + files.front().path + " (" +
           std::string(cut_text(push.hash, kShownOfHash)) + ")");
  send({.id = push.id,
        .hash = push.hash,
        .running_hash = ledger_.running_hash(),
        .status = status::RECEIVED});
  auto checked = bhdl::check(std::move(files), vocabulary_);
  if (!checked.program)
    return reject(push, "the program has errors", to_messages(checked.diagnostics));
  push.warnings = to_messages(checked.diagnostics);
  run_program(std::move(*checked.program), message, std::move(push));
}

Result<void> ProgramReceiver::admit(const msg::ProgramPush& push,
                                    const std::vector<bhdl::SourceFile>& files) const {
  if (files.empty()) return Error{"the push contains no file"};
  if (bhdl::program_hash(files) != push.hash)
    return Error{"its hash does not match its files: they were changed on the way"};
  return check_rules(push);
}

// Only after its turn it is certain which program this one would replace.
void ProgramReceiver::run_program(bhdl::Program program, const msg::ProgramPush& message,
                                  PushLedger::Push push) {
  if (!wait_for_turn(source_.executive)) return reject(push, "the control loop stands still");
  auto taken =
      ledger_.load(std::move(program), rules_of(message, source_.executive.probation_rules()), push,
                   message.replaces_hash);
  if (!taken) return reject(push, taken.error().message);
  for (auto& reply : taken.value()) send(std::move(reply));
  if (const auto running = ledger_.running();
      source_.keep && running.proven && running.hash() == push.hash)
    source_.keep(running.program->program, true);
}

/// A program that may yet be rolled back is none to begin with after a crash.
void ProgramReceiver::keep_proven(const Event& event) const {
  const bool is_proven = event.kind == Event::Kind::kConfirmed ||
                         (event.kind == Event::Kind::kRolledBack && !event.in_probation);
  if (!source_.keep || !is_proven) return;
  if (const auto proven = source_.executive.description(event.program))
    source_.keep(proven->program, ledger_.pushed(event.program));
}

void ProgramReceiver::on_event(const Event& event) {
  keep_proven(event);
  for (auto& reply : ledger_.answers(event)) send(std::move(reply));
}

msg::ProgramReply ProgramReceiver::rejection(const PushLedger::Push& push, std::string why,
                                             std::vector<msg::Diagnostic> diagnostics) const {
  return {.id = push.id,
          .hash = push.hash,
          .running_hash = ledger_.running_hash(),
          .status = status::REJECTED,
          .message = std::move(why),
          .diagnostics = std::move(diagnostics)};
}

void ProgramReceiver::reject(const PushLedger::Push& push, std::string why,
                             std::vector<msg::Diagnostic> diagnostics) {
  log_rejection(push.hash, why);
  send(rejection(push, std::move(why), std::move(diagnostics)));
}

void ProgramReceiver::refuse(const PushLedger::Push& push, const OrderRefusal& refusal) {
  // The first answer to a push is the true one. Whoever sends it again must not change it.
  if (refusal.kind == OrderRefusal::Kind::kReplayed || is_answered(push)) return;
  const Time now = source_.clock.now();
  if (now - refusing_since_ >= std::chrono::seconds(1)) {
    refusing_since_ = now;
    refusals_ = 0;
  }
  if (++refusals_ > kRefusalsEachSecond) return;
  // It is not remembered: a stranger who sends a push first must not spoil the true one's answer.
  write(stamped(rejection(push, with_advice(refusal), {})));
}

void ProgramReceiver::send(msg::ProgramReply reply) {
  reply = stamped(std::move(reply));
  remember(reply);
  write(reply);
}

msg::ProgramReply ProgramReceiver::stamped(msg::ProgramReply reply) const {
  reply.stamp = WallTime::now();
  reply.robot = source_.robot;
  return reply;
}

void ProgramReceiver::write(const msg::ProgramReply& reply) {
  if (!replies_.write(reply))
    log_warning("the answer to push " + reply.id +
                " could not be sent, because DDS did not accept it");
}

void ProgramReceiver::remember(const msg::ProgramReply& reply) {
  constexpr std::size_t kMostRemembered = 64;
  const std::lock_guard lock(answered_mutex_);
  std::erase_if(answered_, [&](const msg::ProgramReply& known) {
    return known.id == reply.id && known.hash == reply.hash;
  });
  answered_.push_back(reply);
  if (answered_.size() > kMostRemembered) answered_.pop_front();
}

bool ProgramReceiver::is_answered(const PushLedger::Push& push) {
  const std::lock_guard lock(answered_mutex_);
  return std::ranges::any_of(answered_, [&](const msg::ProgramReply& known) {
    return known.id == push.id && known.hash == push.hash;
  });
}

bool ProgramReceiver::answer_again(const msg::ProgramPush& push) {
  std::optional<msg::ProgramReply> answer;
  {
    const std::lock_guard lock(answered_mutex_);
    for (const auto& known : answered_)
      if (known.id == push.id && known.hash == push.hash) answer = known;
  }
  if (!answer) return false;
  if (!replies_.write(*answer))
    log_warning("the answer to push " + push.id +
                " could not be sent again, because DDS did not accept it");
  return true;
}

}  // namespace galilean::robot
