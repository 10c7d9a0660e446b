// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <spdlog/spdlog.h>

#include "core/wire/topic_names.h"
#include "tests/robot/telemetry/telemetry_robot.h"

namespace galilean::robot {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(Publisher, ALateJoinerLearnsStateProgramVariablesAndCatalogAtOnce) {
  TelemetryRobot io("late");
  ASSERT_TRUE(io.robot.load(kWaits));
  io.robot.tick(10);
  auto state = io.mailbox<msg::RobotState>("state");
  const auto current =
      state.wait_for([](const msg::RobotState& message) { return message.state == "wait"; });
  ASSERT_TRUE(current);
  EXPECT_EQ(current->robot, "late");
  EXPECT_EQ(current->program_name, "test.bhdl");
  EXPECT_EQ(current->program_hash, bhdl::program_hash({{"test.bhdl", kWaits}}));
  EXPECT_FLOAT_EQ(current->tick_period_s, 0.05F);
  EXPECT_FALSE(current->held);
  EXPECT_THAT(current->problems, ElementsAre());

  const auto program = io.mailbox<msg::Program>("program").wait();
  ASSERT_TRUE(program);
  EXPECT_EQ(program->files.at(0).text, kWaits);
  EXPECT_EQ(program->start_state, "wait");
  ASSERT_EQ(program->states.size(), 2U);
  EXPECT_THAT(program->states[1].motor_schemas, ElementsAre("ahead"));
  ASSERT_EQ(program->transitions.size(), 1U);
  EXPECT_EQ(program->transitions[0].to_state, "go");
  EXPECT_EQ(program->transitions[0].line, 13U);

  const auto catalog = io.mailbox<msg::Catalog>("catalog").wait();
  ASSERT_TRUE(catalog);
  EXPECT_EQ(catalog->hash, bhdl::sha256(catalog->json));
  EXPECT_TRUE(catalog_from_json(catalog->json).value().find("avoid_obstacle"));
}

TEST(Publisher, ARobotThatAFaultHoldsSaysWhy) {
  TelemetryRobot io("faulty");
  ASSERT_TRUE(io.robot.load(kWaits));
  io.robot.executive->hold_after(FaultCause::kRestart);
  io.robot.tick(10);
  auto state = io.mailbox<msg::RobotState>("state");
  const auto held = state.wait_for(
      [](const msg::RobotState& each) { return each.held && !each.problems.empty(); });
  ASSERT_TRUE(held);
  EXPECT_THAT(held->problems,
              ElementsAre("held: the robot program died while the robot was running, and was "
                          "started again; resume it, or push a bumper."));
  io.send(msg::Command_Constants::RESUME, 0, "faulty");
  EXPECT_TRUE(io.tick_until([&] { return !io.robot.executive->held(); }));
}

TEST(Publisher, TheReasonOfAHoldIsTheSameSentenceWhileTheFaultLasts) {
  Snapshot snapshot;
  snapshot.standstill.hold = Hold::kFault;
  const auto said = [&](const FaultReport& fault) {
    snapshot.fault = fault;
    return hold_of(snapshot).value().text();
  };
  using std::chrono::milliseconds;
  EXPECT_EQ(said({FaultCause::kSerialLine, milliseconds(1500), false}),
            "held: the serial line is gone; resume it when it is back, or push a bumper.");
  EXPECT_EQ(said({FaultCause::kSerialLine, milliseconds(2500), false}),
            said({FaultCause::kSerialLine, milliseconds(1500), false}));
  EXPECT_EQ(said({FaultCause::kSerialLine, milliseconds(3240), true}),
            "held: the serial line was gone for 3.2 s; resume it, or push a bumper.");
  EXPECT_EQ(said({FaultCause::kCamera, std::chrono::seconds(57), true}),
            "held: the camera was gone for 57 s; resume it, or push a bumper.");
  EXPECT_THAT(said({FaultCause::kStall, std::chrono::minutes(12), true}),
              HasSubstr("stood still for 12 min"));
  EXPECT_EQ(said({FaultCause::kBoard, milliseconds(3240), true}),
            "held: the serial line was gone for 3.2 s, and the board was restarted or exchanged; "
            "resume it, or push a bumper.");
  EXPECT_EQ(said({FaultCause::kNamesake, {}, true}),
            "held: another robot of this name was there when this one started; resume it when "
            "that one is gone.");
  snapshot.standstill.hold = Hold::kOperator;
  EXPECT_FALSE(hold_of(snapshot));
}

TEST(Publisher, VariablesCarryCertaintyAndHowItFades) {
  TelemetryRobot io("fading");
  ASSERT_TRUE(io.robot.load(kWaits));
  io.robot.tick(10);
  auto variables = io.mailbox<msg::Variables>("variables");
  const auto message =
      variables.wait_for([](const msg::Variables& each) { return each.items.size() == 2; });
  ASSERT_TRUE(message);
  const msg::Variable& trash = message->items[0];
  EXPECT_EQ(trash.name, "trash");
  EXPECT_EQ(trash.type, msg::Variable_Constants::LOCATE);
  EXPECT_EQ(trash.object_class, "trash");
  EXPECT_TRUE(trash.valid);
  EXPECT_FLOAT_EQ(trash.certainty, 0.75F);
  EXPECT_FLOAT_EQ(trash.decay_per_s, 1.0F / 60);
  EXPECT_EQ(trash.updated, message->stamp);
  ASSERT_EQ(trash.values.size(), 6U);
  EXPECT_EQ(trash.values[0], message->tick);
}

TEST(Publisher, ATransitionComesWithItsCauseAndItsStateBeforeTheNextTick) {
  TelemetryRobot io("cause");
  auto transitions = io.mailbox<msg::Transition>("transition");
  auto states = io.mailbox<msg::RobotState>("state");
  ASSERT_TRUE(io.robot.load(kWaits));
  io.robot.tick(10);
  io.robot.press(2);
  io.robot.tick();
  const auto transition = transitions.wait();
  ASSERT_TRUE(transition);
  EXPECT_EQ(transition->number, 1U);
  EXPECT_EQ(transition->tick, 11U);
  EXPECT_EQ(transition->from_state, "wait");
  EXPECT_EQ(transition->to_state, "go");
  EXPECT_EQ(transition->cause, "bumpers[2] became 1");
  EXPECT_EQ(transition->file, "test.bhdl");
  EXPECT_EQ(transition->line, 13U);
  EXPECT_THAT(transition->reset_variables, ElementsAre("trash"));
  ASSERT_EQ(transition->tested.size(), 1U);
  EXPECT_EQ(transition->tested[0].to_state, "go");
  EXPECT_EQ(transition->tested[0].line, 13U);
  EXPECT_TRUE(transition->tested[0].holds);
  const auto state =
      states.wait_for([](const msg::RobotState& message) { return message.state == "go"; });
  ASSERT_TRUE(state);
  EXPECT_EQ(state->transitions, 1U);
  EXPECT_TRUE(io.mailbox<msg::Variables>("variables").wait_for([&](const msg::Variables& message) {
    return message.tick >= transition->tick;
  }));
}

TEST(Publisher, SaysWhichDeviceIsMissingAndWhenItIsBack) {
  TelemetryRobot io("lost");
  auto states = io.mailbox<msg::RobotState>("state");
  ASSERT_TRUE(io.robot.load(kWaits));
  io.robot.port.answers = false;
  io.robot.tick(5);
  const auto lost =
      states.wait_for([](const msg::RobotState& message) { return !message.problems.empty(); });
  ASSERT_TRUE(lost);
  EXPECT_THAT(lost->problems, ElementsAre("comm_port: unplugged"));
  io.robot.port.answers = true;
  io.robot.tick(5);
  EXPECT_TRUE(states.wait_for(
      [](const msg::RobotState& message) { return message.tick > 5 && message.problems.empty(); }));
}

TEST(Publisher, WhatIsLoggedIsHeardOnRosout) {
  TelemetryRobot io("logging");
  Mailbox<msg::Log> log(*io.other, wire::kLogTopic);
  spdlog::warn("the left tread squeaks");
  const auto line =
      log.wait_for([](const msg::Log& message) { return message.msg == "the left tread squeaks"; });
  ASSERT_TRUE(line);
  EXPECT_EQ(line->level, 30);
  EXPECT_EQ(line->name, "logging");
}

TEST(Publisher, AStalledControlLoopIsReported) {
  TelemetryRobot io("stalled");
  auto states = io.mailbox<msg::RobotState>("state");
  ASSERT_TRUE(io.robot.load(kWaits));
  io.robot.tick(5);
  io.robot.clock.advance(std::chrono::seconds(5));
  const auto stalled = states.wait_for([](const msg::RobotState& message) {
    return message.tick == 5 && !message.problems.empty();
  });
  ASSERT_TRUE(stalled);
  EXPECT_THAT(stalled->problems.back(), HasSubstr("stands still"));
}

TEST(Publisher, TellsWhatTheRobotsThreadsCannotDoUntilTheyCan) {
  TelemetryRobot io("threads");
  auto states = io.mailbox<msg::RobotState>("state");
  ASSERT_TRUE(io.robot.load(kWaits));
  auto& problems = io.telemetry->problems();
  const auto report = problems.reporter("image_publisher");
  problems.note("watch", "Saves are not noticed.");
  report("no paper");
  io.robot.tick(5);
  const auto troubled = states.wait_for([](const auto& state) { return !state.problems.empty(); });
  ASSERT_TRUE(troubled);
  EXPECT_THAT(troubled->problems,
              ElementsAre(HasSubstr("image_publisher: It failed (no paper) and is tried again"),
                          "watch: Saves are not noticed."));
  problems.note("watch", "");
  report("");
  io.robot.tick(5);
  EXPECT_TRUE(states.wait_for(
      [](const auto& state) { return state.tick == 10 && state.problems.empty(); }));
}

TEST(Publisher, PublishesOnAfterAFailure) {
  TelemetryRobot io("failing");
  io.telemetry.reset();
  LogQueue log;
  const LogForwarding forwarding(log);
  const ThreadProblems threads;
  bool failed = false;
  const Publisher publisher({.robot = io.name,
                             .participant = *io.participant,
                             .executive = *io.robot.executive,
                             .tap = io.tap,
                             .devices = {io.robot.port, io.robot.drive, io.robot.camera},
                             .catalog = test_components().catalog(),
                             .clock = io.robot.clock},
                            log, threads,
                            {.event =
                                 [&](const Event&) {
                                   if (!std::exchange(failed, true))
                                     throw std::runtime_error("no paper");
                                 },
                             .round = [](const Snapshot&) {}});
  auto lines = Mailbox<msg::Log>(*io.other, wire::kLogTopic);
  auto states = io.mailbox<msg::RobotState>("state");
  ASSERT_TRUE(io.robot.load(kWaits));
  io.robot.tick();
  EXPECT_TRUE(lines.wait_for([](const msg::Log& line) {
    return line.name == "failing" && line.msg == "telemetry failed (no paper) and is tried again";
  }));
  io.robot.tick(3);
  EXPECT_TRUE(states.wait_for([](const msg::RobotState& state) { return state.tick == 4; }));
}

TEST(ImagePublisher, EncodesWhatSomebodyReads) {
  TelemetryRobot io("seen");
  auto pictures = io.mailbox<msg::CompressedImage>("camera/compressed");
  ASSERT_TRUE(io.robot.load(kWaits));
  ASSERT_TRUE(io.tick_until([&] {
    ++io.robot.camera.picture.number;
    return !pictures.all().empty();
  }));
  const msg::CompressedImage picture = pictures.all().front();
  EXPECT_EQ(picture.format, "jpeg");
  EXPECT_EQ(picture.header.frame_id, "seen/camera");
  ASSERT_GT(picture.data.size(), 100U);
  EXPECT_EQ(picture.data[0], 0xff);
  EXPECT_EQ(picture.data[1], 0xd8);
}

}  // namespace
}  // namespace galilean::robot
