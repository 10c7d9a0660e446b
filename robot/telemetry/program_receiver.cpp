#include "robot/telemetry/program_receiver.h"

#include <spdlog/spdlog.h>

#include <utility>

#include "bhdl/sha256.h"
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

}  // namespace

ProgramReceiver::ProgramReceiver(const TelemetrySource& source)
    : source_(source),
      ledger_(source.executive),
      replies_(source.participant, wire::robot_topic(source.robot, "program_reply")),
      pushes_(source.participant, wire::kProgramPushTopic, msg::ProgramPush::kRosType) {
  pushes_.on_data([this] {
    const std::lock_guard lock(mutex_);
    arrived_ = true;
    wake_.notify_one();
  });
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

void ProgramReceiver::run(const std::stop_token& stop) {
  while (true) {
    {
      std::unique_lock lock(mutex_);
      if (!wake_.wait(lock, stop, [this] { return std::exchange(arrived_, false); })) return;
    }
    take();
  }
}

void ProgramReceiver::take() {
  pushes_.take([this](const wire::Received& received) {
    msg::ProgramPush push;
    if (!msg::decode_cdr(received.cdr, push)) return;
    if (is_meant(source_.robot, push.targets)) handle(push);
  });
}

void ProgramReceiver::handle(const msg::ProgramPush& message) {
  PushLedger::Push push{message.id, message.hash, {}};
  auto files = files_of(message);
  if (std::string why = objection(message, files); !why.empty())
    return reject(push, std::move(why));
  spdlog::info("program {} ({:.8}) pushed by {}", files.front().path, push.hash, message.author);
  send({.id = push.id,
        .hash = push.hash,
        .running_hash = ledger_.running().hash(),
        .status = status::RECEIVED});
  auto checked = bhdl::check(std::move(files), source_.catalog);
  if (!checked.program)
    return reject(push, "the program has errors", to_messages(checked.diagnostics));
  push.warnings = to_messages(checked.diagnostics);
  run_program(std::move(*checked.program), std::move(push));
}

std::string ProgramReceiver::objection(const msg::ProgramPush& push,
                                       const std::vector<bhdl::SourceFile>& files) const {
  if (files.empty()) return "no file came with it";
  if (bhdl::program_hash(files) != push.hash)
    return "its hash is not that of its files: they were changed on the way";
  const std::string running = ledger_.running().hash();
  if (!push.replaces_hash.empty() && push.replaces_hash != running)
    return "it is to replace " + push.replaces_hash + ", but " + running + " runs";
  return {};
}

void ProgramReceiver::run_program(bhdl::Program program, PushLedger::Push push) {
  if (!wait_for_turn()) return reject(push, "the control loop stands still");
  if (ledger_.running().hash() == push.hash) {
    for (auto& reply : ledger_.join_running(std::move(push))) send(std::move(reply));
    return;
  }
  const auto loaded = ledger_.load(std::move(program), push);
  if (!loaded) reject(push, loaded.error().message);
}

/// The program before may have been pushed within the same tick.
bool ProgramReceiver::wait_for_turn() const {
  constexpr Duration kPatience = std::chrono::seconds(1);
  constexpr Duration kPause = std::chrono::milliseconds(2);
  for (Duration waited{}; source_.executive.waiting(); waited += kPause) {
    if (waited > kPatience) return false;
    std::this_thread::sleep_for(kPause);
  }
  return true;
}

void ProgramReceiver::on_event(const Event& event) {
  for (auto& reply : ledger_.answers(event)) send(std::move(reply));
}

void ProgramReceiver::reject(const PushLedger::Push& push, std::string why,
                             std::vector<msg::Diagnostic> diagnostics) {
  spdlog::warn("program {:.8} rejected: {}", push.hash, why);
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
    spdlog::warn("the answer to push {} could not be sent: the network stalls", reply.id);
}

}  // namespace galilean::robot
