// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/source/sha256.h"
#include "core/wire/topic_names.h"
#include "core/wire/writer.h"
#include "robot/telemetry/telemetry.h"
#include "tests/free_domain.h"
#include "tests/robot/executive/test_robot.h"
#include "tests/robot/telemetry/mailbox.h"

namespace galilean::robot {

inline const int kDomain = free_domain();

/// A scripted robot on DDS, with a monitor in the same domain. Each robot has a name of its own, so
/// that a test does not hear the robot of the test before.
class TelemetryRobot {
 public:
  explicit TelemetryRobot(std::string robot_name, const Registry& components = test_components(),
                          std::optional<TrustedKeys> trust = std::nullopt)
      : name(std::move(robot_name)),
        participant(join(name)),
        other(join(wire::kMonitorName)),
        images(components.catalog()),
        robot(1, {&tap, &images, &inputs}, {}, components),
        telemetry(std::in_place,
                  TelemetrySource{.robot = name,
                                  .participant = *participant,
                                  .executive = *robot.executive,
                                  .tap = tap,
                                  .devices = {robot.port, robot.drive, robot.camera},
                                  .catalog = components.catalog(),
                                  .clock = robot.clock,
                                  .accepted_senders = AcceptedSenders(senders_of(trust)),
                                  .keep =
                                      [this](const bhdl::Program& program, bool pushed) {
                                        const std::lock_guard lock(kept_mutex_);
                                        kept_.emplace_back(program.hash, pushed);
                                      },
                                  .trust = std::move(trust)},
                  images, inputs) {
    ++living_;
  }
  ~TelemetryRobot() { --living_; }
  TelemetryRobot(const TelemetryRobot&) = delete;
  TelemetryRobot& operator=(const TelemetryRobot&) = delete;

  template <class M>
  [[nodiscard]] Mailbox<M> mailbox(const std::string& leaf) {
    return Mailbox<M>(*other, wire::robot_topic(name, leaf));
  }
  /// Returns the programs to begin with after a crash, the oldest first, by their hashes, and
  /// whether pushes brought them.
  [[nodiscard]] std::vector<std::pair<std::string, bool>> kept() {
    const std::lock_guard lock(kept_mutex_);
    return kept_;
  }
  /// Returns a push as the monitor would send it.
  [[nodiscard]] msg::ProgramPush push(const std::string& text) const {
    msg::ProgramPush push;
    push.id = "push of " + name;
    push.author = "tester";
    push.targets = {name};
    push.files.push_back({"test.bhdl", text});
    push.hash = bhdl::program_hash({{"test.bhdl", text}});
    return push;
  }
  void send(const msg::ProgramPush& push) { send_on(wire::kProgramPushTopic, push); }
  void send(const msg::ProgramRollback& order) { send_on(wire::kProgramRollbackTopic, order); }
  void send(const msg::Command& command) { send_on(wire::kCommandTopic, command); }
  void send(const msg::TeamStop& stop) { send_on(wire::kTeamStopTopic, stop); }
  void send(const msg::BreakOrder& order) { send_on(wire::kBreakOrderTopic, order); }
  void send(std::uint8_t kind, std::int32_t argument, const std::string& target) {
    msg::Command command;
    command.author = "tester";
    command.targets = {target};
    command.kind = kind;
    command.argument = argument;
    send(command);
  }
  /// Ticks until `done` is true, for at most 10 s. Returns whether it became true.
  bool tick_until(const std::function<bool()>& done) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (!done() && std::chrono::steady_clock::now() < end) {
      robot.tick();
      std::this_thread::yield();
    }
    return done();
  }

  std::string name;

 private:
  // Before telemetry, which uses them until it ends.
  std::mutex kept_mutex_;
  std::vector<std::pair<std::string, bool>> kept_;

 public:
  std::unique_ptr<wire::Participant> participant;
  std::unique_ptr<wire::Participant> other;
  SnapshotTap tap;
  ImageTap images;
  InputsTap inputs;
  TestRobot robot;
  std::optional<Telemetry> telemetry;

 private:
  /// Where orders are signed, programs are taken from anybody who signs them.
  static std::vector<std::string> senders_of(const std::optional<TrustedKeys>& trust) {
    return {trust ? AcceptedSenders::kAny : wire::kMonitorName};
  }
  static std::unique_ptr<wire::Participant> join(const std::string& who) {
    auto joined = wire::Participant::join(who, kDomain);
    if (!joined) throw std::runtime_error(joined.error().message);
    return std::move(joined).value();
  }
  template <class M>
  void send_on(const std::string& topic, const M& message) {
    // The writer stays alive, because a robot looks up who sent a message.
    const auto writer = std::make_shared<wire::Writer<M>>(*other, topic);
    writers_.push_back(writer);
    while (writer->readers() < living_) std::this_thread::yield();
    EXPECT_TRUE(writer->write(message));
  }

  static inline int living_ = 0;
  std::vector<std::shared_ptr<void>> writers_;
};

inline constexpr const char* kWaits = R"(
variables:
  bits: name: "bumpers"
  locate: name: "trash" class: "trash"
end
perceptual_schemas:
  bumper_scanner: name: "scan" bits_variable: "bumpers" end
  write_all: name: "see" locate_variable: "trash" certainty: 0.75 end
end
motor_schemas: ahead: name: "ahead" end end
states:
  state: name: "wait" perceptual_schemas: "scan" "see" end
    condition: bits_variable: "bumpers" bit_index: 2 bit_value: 1
      reset_variables: "trash" new_state: "go" end
  end
  state: name: "go" perceptual_schemas: "scan" end motor_schemas: "ahead" end end
end
)";

}  // namespace galilean::robot
