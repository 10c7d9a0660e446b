// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "core/wire/messages.h"
#include "core/wire/participant.h"
#include "core/wire/reader.h"
#include "core/wire/writer.h"

namespace galilean::monitor {

/// A robot as it appears on DDS, without the robot behind it. It publishes a state ten times a
/// second, takes pushes and commands, and answers as a robot does. Tests of programs that watch and
/// command robots use it.
class ScriptedRobot {
 public:
  /// `catalog_json` is the catalog that its programs are checked with.
  ScriptedRobot(std::string name, int domain, const std::string& catalog_json);
  ~ScriptedRobot();

  /// From now on refuses pushes with this reason.
  void refuse_pushes(const std::string& why);
  /// From now on runs a program that it was sent before, and tells so in its state alone.
  void run_silently(const std::string& hash);
  /// Answers a push as one whose answer was long on its way, with a status of msg::ProgramReply.
  void answer(const std::string& push_id, const std::string& hash, std::uint8_t status);
  void confirm(const std::string& push_id, const std::string& hash) {
    answer(push_id, hash, msg::ProgramReply_Constants::CONFIRMED);
  }
  [[nodiscard]] std::string running_hash();
  [[nodiscard]] bool held();
  [[nodiscard]] bool out_of_service();
  void change_state(const std::string& to);
  [[nodiscard]] std::string name() const { return name_; }

 private:
  void run();
  void take_push(const msg::ProgramPush& push);
  void take_rollback(const msg::ProgramRollback& order);
  void take_command(const msg::Command& command);
  void run_program(msg::Program program);
  [[nodiscard]] bool is_meant(const std::vector<std::string>& targets) const;
  void reply(const std::string& id, const std::string& hash, std::uint8_t status,
             const std::string& message = {});

  std::string name_;
  std::unique_ptr<wire::Participant> participant_;
  wire::Writer<msg::RobotState> states_;
  wire::Writer<msg::Catalog> catalogs_;
  wire::Writer<msg::Transition> transitions_;
  wire::Writer<msg::Program> programs_;
  wire::Writer<msg::ProgramReply> replies_;
  wire::Reader pushes_;
  wire::Reader rollbacks_;
  wire::Reader commands_;

  std::mutex mutex_;
  std::condition_variable wake_;
  bool ending_ = false;
  bool has_data_ = false;
  msg::RobotState state_;
  msg::Program running_;
  msg::Program before_;
  std::string refusal_;
  std::uint64_t transitions_written_ = 0;
  std::thread thread_;
};

}  // namespace galilean::monitor
