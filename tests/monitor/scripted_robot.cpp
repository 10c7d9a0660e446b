// SPDX-License-Identifier: BSD-3-Clause
#include "tests/monitor/scripted_robot.h"

#include <algorithm>

#include "core/wire/ros_time.h"
#include "core/wire/topic_names.h"

namespace galilean::monitor {
namespace {

msg::Program program_of(const std::string& hash, const std::vector<msg::SourceFile>& files) {
  msg::Program program;
  program.name = files.front().path;
  program.hash = hash;
  program.files = files;
  return program;
}

}  // namespace

ScriptedRobot::ScriptedRobot(std::string name, int domain, const std::string& catalog_json)
    : name_(std::move(name)),
      participant_(wire::Participant::join("scripted-" + name_, domain).value()),
      states_(*participant_, wire::robot_topic(name_, "state")),
      catalogs_(*participant_, wire::robot_topic(name_, "catalog")),
      transitions_(*participant_, wire::robot_topic(name_, "transition")),
      programs_(*participant_, wire::robot_topic(name_, "program")),
      replies_(*participant_, wire::robot_topic(name_, "program_reply")),
      pushes_(*participant_, wire::kProgramPushTopic, msg::ProgramPush::kRosType),
      rollbacks_(*participant_, wire::kProgramRollbackTopic, msg::ProgramRollback::kRosType),
      commands_(*participant_, wire::kCommandTopic, msg::Command::kRosType) {
  state_.robot = name_;
  state_.state = "start";
  state_.tick_period_s = 0.05F;
  run_program(program_of("first", {{"first.bhdl", "states:\n"}}));
  (void)catalogs_.write(
      {name_, std::to_string(std::hash<std::string>()(catalog_json)), catalog_json});
  const auto wake = [this] {
    {
      const std::lock_guard lock(mutex_);
      has_data_ = true;
    }
    wake_.notify_one();
  };
  pushes_.on_data(wake);
  rollbacks_.on_data(wake);
  commands_.on_data(wake);
  thread_ = std::thread([this] { run(); });
}

ScriptedRobot::~ScriptedRobot() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void ScriptedRobot::run() {
  for (;;) {
    {
      std::unique_lock lock(mutex_);
      state_.stamp = wire::ros_time(wire::wall_clock_ns());
      ++state_.tick;
      (void)states_.write(state_);
      wake_.wait_for(lock, std::chrono::milliseconds(100), [this] { return ending_ || has_data_; });
      if (ending_) return;
      has_data_ = false;
    }
    pushes_.take([this](const wire::Received& received) {
      msg::ProgramPush push;
      if (msg::decode_cdr(received.cdr, push)) take_push(push);
    });
    rollbacks_.take([this](const wire::Received& received) {
      msg::ProgramRollback order;
      if (msg::decode_cdr(received.cdr, order)) take_rollback(order);
    });
    commands_.take([this](const wire::Received& received) {
      msg::Command command;
      if (msg::decode_cdr(received.cdr, command)) take_command(command);
    });
  }
}

bool ScriptedRobot::is_meant(const std::vector<std::string>& targets) const {
  return targets.empty() || std::ranges::find(targets, name_) != targets.end();
}

void ScriptedRobot::take_push(const msg::ProgramPush& push) {
  if (!is_meant(push.targets) || (push.targets.empty() && out_of_service())) return;
  using namespace msg::ProgramReply_Constants;
  reply(push.id, push.hash, RECEIVED);
  const std::lock_guard lock(mutex_);
  if (!refusal_.empty()) return reply(push.id, push.hash, REJECTED, refusal_);
  before_ = running_;
  run_program(program_of(push.hash, push.files));
  reply(push.id, push.hash, RUNNING);
}

void ScriptedRobot::take_rollback(const msg::ProgramRollback& order) {
  if (!is_meant(order.targets)) return;
  const std::lock_guard lock(mutex_);
  if (order.hash != running_.hash)
    return reply(order.id, order.hash, msg::ProgramReply_Constants::REJECTED, "another runs");
  run_program(before_);
  reply(order.id, order.hash, msg::ProgramReply_Constants::ROLLED_BACK, order.reason);
}

void ScriptedRobot::run_program(msg::Program program) {
  program.robot = name_;
  state_.program_hash = program.hash;
  state_.program_name = program.name;
  (void)programs_.write(program);
  running_ = std::move(program);
}

void ScriptedRobot::reply(const std::string& id, const std::string& hash, std::uint8_t status,
                          const std::string& message) {
  msg::ProgramReply reply;
  reply.stamp = wire::ros_time(wire::wall_clock_ns());
  reply.id = id;
  reply.robot = name_;
  reply.hash = hash;
  reply.running_hash = state_.program_hash;
  reply.status = status;
  reply.message = message;
  if (status == msg::ProgramReply_Constants::RUNNING) reply.kept_variables = {"shaft"};
  const bool tells_of_swap = status == msg::ProgramReply_Constants::RUNNING ||
                             status == msg::ProgramReply_Constants::ROLLED_BACK;
  if (tells_of_swap) reply.tick = state_.tick + 1;
  (void)replies_.write(reply);
}

void ScriptedRobot::take_command(const msg::Command& command) {
  if (!is_meant(command.targets)) return;
  const std::lock_guard lock(mutex_);
  if (command.kind == msg::Command_Constants::HOLD) state_.held = true;
  if (command.kind == msg::Command_Constants::RESUME) state_.held = false;
  if (command.kind == msg::Command_Constants::DECOMMISSION) state_.out_of_service = true;
  if (command.kind == msg::Command_Constants::COMMISSION) state_.out_of_service = false;
}

void ScriptedRobot::refuse_pushes(const std::string& why) {
  const std::lock_guard lock(mutex_);
  refusal_ = why;
}

void ScriptedRobot::run_silently(const std::string& hash) {
  const std::lock_guard lock(mutex_);
  state_.program_hash = running_.hash = hash;
}

void ScriptedRobot::answer(const std::string& push_id, const std::string& hash,
                           std::uint8_t status) {
  const std::lock_guard lock(mutex_);
  reply(push_id, hash, status);
}

std::string ScriptedRobot::running_hash() {
  const std::lock_guard lock(mutex_);
  return state_.program_hash;
}

bool ScriptedRobot::held() {
  const std::lock_guard lock(mutex_);
  return state_.held;
}

bool ScriptedRobot::out_of_service() {
  const std::lock_guard lock(mutex_);
  return state_.out_of_service;
}

void ScriptedRobot::change_state(const std::string& to) {
  const std::lock_guard lock(mutex_);
  msg::Transition transition;
  transition.robot = name_;
  transition.number = ++transitions_written_;
  transition.from_state = state_.state;
  transition.to_state = state_.state = to;
  (void)transitions_.write(transition);
}

}  // namespace galilean::monitor
