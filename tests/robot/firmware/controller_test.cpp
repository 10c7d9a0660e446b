// SPDX-License-Identifier: BSD-3-Clause
#include "robot/firmware/controller.h"

#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <random>

#include "tests/robot/firmware/bench_board.h"

namespace galilean::robot::firmware {
namespace {

constexpr std::uint16_t kTimeout_ms = 300;
constexpr std::int16_t kSpeed = 100 * kCountsPerTick;

class ControllerOnTheBench : public testing::Test {
 protected:
  template <class Message>
  std::uint16_t send(const Message& message) {
    ++sequence_;
    send_again(message);
    return sequence_;
  }
  /// Sends it with the sequence of the message before.
  template <class Message>
  void send_again(const Message& message) {
    std::array<std::uint8_t, kMaxEncoded> bytes;
    const auto size = encode_message(message, sequence_, bytes);
    board_.to_board.insert(board_.to_board.end(), bytes.begin(),
                           bytes.begin() + static_cast<std::ptrdiff_t>(size));
  }
  void run(std::uint32_t milliseconds) {
    for (std::uint32_t i = 0; i < milliseconds; ++i) {
      controller_.update(++now_ms_);
      board_.step(0.001);
    }
    listen();
  }
  /// Sends `drive` again and again, as a control loop does.
  void keep_driving(const Drive& drive, std::uint32_t milliseconds) {
    for (std::uint32_t i = 0; i < milliseconds; i += 20) {
      send(drive);
      run(20);
    }
  }
  /// Sends one `drive`, and the same again and again, as a robot does between two commands.
  void drive_once(const Drive& drive, std::uint32_t milliseconds) {
    send(drive);
    for (std::uint32_t i = 0; i < milliseconds; i += 20) {
      run(20);
      send_again(drive);
    }
  }
  void listen() {
    for (const auto byte : board_.from_board)
      if (decoder_.push(byte)) take(decoder_.frame());
    board_.from_board.clear();
  }
  void take(const Frame& frame) {
    if (unpack_as(frame, status_)) ++statuses_;
    unpack_as(frame, reply_);
    unpack_as(frame, answer_);
  }
  template <class Message>
  static bool unpack_as(const Frame& frame, std::optional<Message>& message) {
    if (frame.type != static_cast<std::uint8_t>(Message::kType)) return false;
    return unpack(frame, message.emplace());
  }
  Result result() const { return static_cast<Result>(answer_->result); }
  void configure() {
    send(bench_parameters(kTimeout_ms));
    run(2);
    answer_.reset();
  }
  bool flag(std::uint8_t bit) const { return status_->flags & bit; }

  BenchBoard board_;
  std::uint32_t now_ms_ = 0;
  Controller controller_{board_, {{'i', 'o'}, 7}};
  std::uint16_t sequence_ = 0;
  FrameDecoder decoder_;
  std::optional<Status> status_;
  std::optional<HelloReply> reply_;
  std::optional<Acknowledgement> answer_;
  int statuses_ = 0;
};

TEST_F(ControllerOnTheBench, ReportsFiftyTimesASecondFromTheStart) {
  run(1000);
  EXPECT_EQ(statuses_, 50);
  EXPECT_EQ(status_->uptime_ms, 1000u);
  EXPECT_EQ(status_->boot_count, 7);
  EXPECT_FALSE(flag(status_flag::kParametersReceived));
}

TEST_F(ControllerOnTheBench, TellsWhoItIs) {
  send(Hello{});
  run(2);
  ASSERT_TRUE(reply_);
  EXPECT_EQ(reply_->version, kProtocolVersion);
  EXPECT_EQ(reply_->firmware_version, kFirmwareVersion);
  EXPECT_STREQ(reinterpret_cast<const char*>(reply_->name.data()), "io");
  EXPECT_FALSE(answer_);
}

TEST_F(ControllerOnTheBench, TellsItsVersionToARobotThatSpeaksAnother) {
  send(Hello{99});
  run(2);
  ASSERT_TRUE(reply_);
  ASSERT_TRUE(answer_);
  EXPECT_EQ(result(), Result::kWrongVersion);
}

TEST_F(ControllerOnTheBench, DoesNotMoveBeforeItHasParameters) {
  send(Drive{kSpeed, kSpeed, 0, 0});
  run(500);
  ASSERT_TRUE(answer_);
  EXPECT_EQ(result(), Result::kNoParameters);
  EXPECT_EQ(board_.outputs.left_pwm, 0);
}

TEST_F(ControllerOnTheBench, TellsTheSpeedThatItHasWheneverItsLoopIsCalled) {
  std::mt19937 random(6);
  std::uniform_int_distribution<std::uint32_t> steps_ms(1, 60);
  configure();
  keep_driving({kSpeed, kSpeed, 0, 0}, 3000);
  for (int i = 0; i < 200; ++i) {
    send(Drive{kSpeed, kSpeed, 0, 0});
    const std::uint32_t step_ms = steps_ms(random);
    for (std::uint32_t each = 0; each < step_ms; ++each) board_.step(0.001);
    now_ms_ += step_ms;
    controller_.update(now_ms_);
    listen();
    ASSERT_NEAR(status_->left_speed_counts_s, kSpeed, 0.15 * kSpeed) << i;
    ASSERT_NEAR(board_.left.speed_counts_s(), kSpeed, 0.15 * kSpeed) << i;
  }
}

TEST_F(ControllerOnTheBench, RefusesParametersThatItCannotWorkWith) {
  const auto refused = [this](auto&& spoil) {
    Parameters p = bench_parameters(kTimeout_ms);
    spoil(p);
    answer_.reset();
    const auto sequence = send(p);
    run(2);
    return answer_ && result() == Result::kOutOfRange && answer_->sequence == sequence;
  };
  EXPECT_TRUE(refused([](auto& p) { p.timeout_ms = 0; }));
  EXPECT_TRUE(refused([](auto& p) { p.acceleration_ticks_s2 = 0; }));
  EXPECT_TRUE(refused([](auto& p) { p.proportional_gain = -1; }));
  EXPECT_TRUE(refused([](auto& p) { p.integral_gain = std::numeric_limits<float>::quiet_NaN(); }));
  EXPECT_TRUE(
      refused([](auto& p) { p.feedforward_gain = std::numeric_limits<float>::infinity(); }));
  EXPECT_TRUE(refused([](auto& p) { p.straight_dead_zones.left_forward = -1; }));
  EXPECT_TRUE(refused([](auto& p) { p.turn_dead_zones.right_reverse = 1; }));
  EXPECT_FALSE(refused([](auto&) {}));
  EXPECT_EQ(result(), Result::kAccepted);
}

TEST_F(ControllerOnTheBench, AnswersWhatItDoesNotUnderstand) {
  std::array<std::uint8_t, kMaxEncoded> bytes;
  const auto size = encode({0x44, 5, {}}, bytes);
  board_.to_board.insert(board_.to_board.end(), bytes.begin(),
                         bytes.begin() + static_cast<std::ptrdiff_t>(size));
  run(2);
  ASSERT_TRUE(answer_);
  EXPECT_EQ(result(), Result::kUnknownMessage);
  EXPECT_EQ(answer_->message, 0x44);
  EXPECT_EQ(answer_->sequence, 5);
}

TEST_F(ControllerOnTheBench, AnswersThatAMessageOfAnotherLengthIsMalformed) {
  configure();
  const auto answer_to = [&](MessageType type, std::size_t length) {
    const std::vector<std::uint8_t> payload(length);
    std::array<std::uint8_t, kMaxEncoded> bytes;
    const auto size = encode({static_cast<std::uint8_t>(type), 9, payload}, bytes);
    board_.to_board.insert(board_.to_board.end(), bytes.begin(),
                           bytes.begin() + static_cast<std::ptrdiff_t>(size));
    answer_.reset();
    run(2);
    return answer_.value_or(Acknowledgement{});
  };
  const struct {
    MessageType type;
    std::size_t length;
  } messages[] = {{MessageType::kHello, payload_size<Hello>()},
                  {MessageType::kParameters, payload_size<Parameters>()},
                  {MessageType::kDrive, payload_size<Drive>()},
                  {MessageType::kStop, payload_size<Stop>()},
                  {MessageType::kGripper, payload_size<Gripper>()},
                  {MessageType::kStatusRequest, payload_size<StatusRequest>()}};
  for (const auto& [type, length] : messages)
    for (const std::size_t wrong : {length - 1, length + 1}) {
      if (wrong > kMaxPayload) continue;
      const Acknowledgement answer = answer_to(type, wrong);
      EXPECT_EQ(answer.message, static_cast<std::uint8_t>(type));
      EXPECT_EQ(answer.sequence, 9);
      EXPECT_EQ(static_cast<Result>(answer.result), Result::kMalformed)
          << static_cast<int>(type) << " of " << wrong << " bytes";
    }
}

TEST_F(ControllerOnTheBench, DrivesAtTheSpeedAskedFor) {
  configure();
  keep_driving({kSpeed, kSpeed, 0, 0}, 2000);
  EXPECT_NEAR(status_->left_speed_counts_s, kSpeed, 0.05 * kSpeed);
  EXPECT_NEAR(status_->right_speed_counts_s, kSpeed, 0.05 * kSpeed);
  EXPECT_NEAR(status_->left_encoder_counts, status_->right_encoder_counts, 4);
  EXPECT_EQ(status_->last_command, sequence_);
  EXPECT_TRUE(flag(status_flag::kMotorsActive));
}

TEST_F(ControllerOnTheBench, TurnsOnTheSpotWithTheTurnsDeadZones) {
  board_.left.dead_zone_pwm = board_.right.dead_zone_pwm = 330;
  configure();
  keep_driving({static_cast<std::int16_t>(-kSpeed), kSpeed, 0, 0}, 1000);
  EXPECT_NEAR(status_->left_speed_counts_s, -kSpeed, 0.05 * kSpeed);
  EXPECT_NEAR(status_->right_speed_counts_s, kSpeed, 0.05 * kSpeed);
}

TEST_F(ControllerOnTheBench, GoesNoFasterThanTheParametersSayAndKeepsTheCurve) {
  configure();
  keep_driving({4 * kSpeed, 2 * kSpeed, 0, 0}, 2000);
  EXPECT_NEAR(status_->left_speed_counts_s, kSpeed, 0.05 * kSpeed);
  EXPECT_NEAR(status_->right_speed_counts_s, kSpeed / 2, 0.05 * kSpeed);
}

TEST_F(ControllerOnTheBench, StopsAtTheTravelLimit) {
  Parameters patient = bench_parameters(kTimeout_ms);
  patient.timeout_ms = 10000;
  send(patient);
  drive_once({kSpeed, kSpeed, 1600, 1600}, 4000);
  EXPECT_NEAR(status_->left_encoder_counts, 1600, 10);
  EXPECT_NEAR(status_->right_encoder_counts, 1600, 10);
  EXPECT_FALSE(flag(status_flag::kMotorsActive));
  EXPECT_FALSE(flag(status_flag::kStoppedByTimeout));
}

// The wheels are what counts: a stop that was sent while the loop drove on once hurt other people.
TEST_F(ControllerOnTheBench, WheelsStandAndStayWhenCommandsCease) {
  configure();
  keep_driving({kSpeed, kSpeed, 0, 0}, 1000);
  ASSERT_GT(board_.left.speed_counts_s(), 0.9 * kSpeed);
  run(kTimeout_ms + 500);
  EXPECT_NEAR(board_.left.speed_counts_s(), 0, 5);
  EXPECT_NEAR(board_.right.speed_counts_s(), 0, 5);
  EXPECT_TRUE(flag(status_flag::kStoppedByTimeout));
  EXPECT_FALSE(flag(status_flag::kMotorsActive));
  const auto stood_at = board_.left.counts();
  for (int i = 0; i < 5000; ++i) {
    run(1);
    ASSERT_EQ(board_.outputs.left_pwm, 0);
    ASSERT_EQ(board_.outputs.right_pwm, 0);
  }
  EXPECT_NEAR(board_.left.counts(), stood_at, 2);
}

TEST_F(ControllerOnTheBench, WheelsAreBrakedSoonAfterTheLastCommand) {
  for (const auto speed : {kSpeed, static_cast<std::int16_t>(-kSpeed)}) {
    configure();
    keep_driving({speed, speed, 0, 0}, 1000);
    const int forward = speed > 0 ? 1 : -1;
    run(DriveTrain::kStopTimer_ms - 20);
    EXPECT_GT(board_.outputs.left_pwm * forward, 0);
    run(4);
    EXPECT_LT(board_.outputs.left_pwm * forward, 0) << "it does not brake";
    EXPECT_LT(board_.outputs.right_pwm * forward, 0) << "it does not brake";
    run(100);
    EXPECT_NEAR(board_.left.speed_counts_s(), 0, 0.05 * kSpeed);
    EXPECT_EQ(board_.outputs.left_pwm, 0);
    EXPECT_EQ(board_.outputs.right_pwm, 0);
    EXPECT_TRUE(flag(status_flag::kStoppedByTimeout));
    run(1000);
  }
}

TEST_F(ControllerOnTheBench, OneLostCommandAtTwentyHertzIsNotFelt) {
  configure();
  keep_driving({kSpeed, kSpeed, 0, 0}, 1000);
  for (int i = 0; i < 100; ++i) {
    send(Drive{kSpeed, kSpeed, 0, 0});
    for (int ms = 0; ms < (i % 3 == 0 ? 100 : 50); ++ms) {
      run(1);
      ASSERT_GT(board_.outputs.left_pwm, 0) << i << ", " << ms << " ms";
    }
  }
}

TEST_F(ControllerOnTheBench, ADriveLastsNoLongerThanItsTimeoutHoweverOftenItIsSent) {
  configure();
  drive_once({kSpeed, kSpeed, 0, 0}, kTimeout_ms - 20);
  EXPECT_GT(board_.outputs.left_pwm, 0);
  EXPECT_FALSE(flag(status_flag::kStoppedByTimeout));
  for (int i = 0; i < 20; ++i) {
    send_again(Drive{kSpeed, kSpeed, 0, 0});
    run(20);
  }
  EXPECT_TRUE(flag(status_flag::kStoppedByTimeout));
  EXPECT_EQ(board_.outputs.left_pwm, 0);
}

TEST_F(ControllerOnTheBench, ADriveThatWasStoppedIsNotRevivedByTheSameOnceMore) {
  configure();
  keep_driving({kSpeed, kSpeed, 0, 0}, 500);
  run(DriveTrain::kStopTimer_ms + 200);
  for (int i = 0; i < 10; ++i) {
    send_again(Drive{kSpeed, kSpeed, 0, 0});
    run(20);
    ASSERT_EQ(board_.outputs.left_pwm, 0);
  }
}

TEST_F(ControllerOnTheBench, ANewSessionBrakes) {
  configure();
  keep_driving({kSpeed, kSpeed, 0, 0}, 500);
  send(Drive{kSpeed, kSpeed, 0, 0});
  send(Hello{});
  run(3);
  EXPECT_LT(board_.outputs.left_pwm, 0);
  run(300);
  EXPECT_EQ(board_.outputs.left_pwm, 0);
  EXPECT_NEAR(board_.left.speed_counts_s(), 0, 5);
}

// A wheel whose encoder still counts when it stands must not be powered for ever.
TEST_F(ControllerOnTheBench, BrakingEndsHoweverLongTheWheelIsTurned) {
  configure();
  keep_driving({kSpeed, kSpeed, 0, 0}, 500);
  board_.left.dead_zone_pwm = board_.right.dead_zone_pwm = 2 * kFullPwm;
  board_.left.lag_s = board_.right.lag_s = 100;  // it coasts on, whatever the PWM is
  send(Stop{});
  run(100);
  EXPECT_LT(board_.outputs.left_pwm, 0);
  run(200);
  EXPECT_EQ(board_.outputs.left_pwm, 0);
}

TEST_F(ControllerOnTheBench, OtherMessagesDoNotKeepTheMotorsRunning) {
  configure();
  keep_driving({kSpeed, kSpeed, 0, 0}, 500);
  for (int i = 0; i < 50; ++i) {
    send(StatusRequest{});
    send(Gripper{1});
    send(bench_parameters(kTimeout_ms));
    run(20);
  }
  EXPECT_TRUE(flag(status_flag::kStoppedByTimeout));
  EXPECT_NEAR(board_.left.speed_counts_s(), 0, 5);
}

TEST_F(ControllerOnTheBench, DrivesOnWithTheNextCommandAfterATimeout) {
  configure();
  keep_driving({kSpeed, kSpeed, 0, 0}, 500);
  run(2 * kTimeout_ms);
  keep_driving({kSpeed, kSpeed, 0, 0}, 1500);
  EXPECT_FALSE(flag(status_flag::kStoppedByTimeout));
  EXPECT_NEAR(board_.left.speed_counts_s(), kSpeed, 0.05 * kSpeed);
}

TEST_F(ControllerOnTheBench, StopBrakesAtOnce) {
  configure();
  keep_driving({kSpeed, kSpeed, 0, 0}, 1000);
  send(Stop{});
  run(3);
  EXPECT_LT(board_.outputs.left_pwm, 0);
  EXPECT_LT(board_.outputs.right_pwm, 0);
  run(100);
  EXPECT_EQ(board_.outputs.left_pwm, 0);
  EXPECT_EQ(board_.outputs.right_pwm, 0);
  EXPECT_NEAR(board_.left.speed_counts_s(), 0, 0.05 * kSpeed);
  run(1000);
  EXPECT_NEAR(board_.left.speed_counts_s(), 0, 1);
}

TEST_F(ControllerOnTheBench, TheStopTimerOutlivesTheMillisecondCountersWrap) {
  BenchBoard board;
  Controller controller(board, {});
  std::uint32_t now_ms = std::numeric_limits<std::uint32_t>::max() - 60;
  const auto put = [&](const auto& message) {
    std::array<std::uint8_t, kMaxEncoded> bytes;
    const auto size = encode_message(message, 1, bytes);
    board.to_board.insert(board.to_board.end(), bytes.begin(),
                          bytes.begin() + static_cast<std::ptrdiff_t>(size));
  };
  put(bench_parameters(kTimeout_ms));
  put(Drive{kSpeed, kSpeed, 0, 0});
  for (int i = 0; i < 100; ++i) controller.update(now_ms++), board.step(0.001);
  EXPECT_GT(board.outputs.left_pwm, 0);
  for (int i = 0; i < 150; ++i) controller.update(now_ms++), board.step(0.001);
  EXPECT_EQ(board.outputs.left_pwm, 0);
}

TEST(GripperServo, ClosesInItsTimeHoweverLongItsStepsAre) {
  for (const std::int32_t step_ms : {1, 2, 3, 7, 13}) {
    GripperServo servo;
    servo.close();
    std::int32_t taken_ms = 0;
    for (; servo.state() == GripperState::kClosing; taken_ms += step_ms) servo.step(step_ms);
    EXPECT_GE(taken_ms, GripperServo::kStroke_ms) << step_ms;
    EXPECT_LT(taken_ms, GripperServo::kStroke_ms + step_ms) << step_ms;
    EXPECT_EQ(servo.percent(), 100);
  }
}

TEST_F(ControllerOnTheBench, GripperClosesAndOpensInItsTime) {
  send(Gripper{1});
  run(200);
  EXPECT_EQ(static_cast<GripperState>(status_->gripper_state), GripperState::kClosing);
  EXPECT_NEAR(status_->gripper_percent, 50, 6);
  run(260);
  EXPECT_EQ(static_cast<GripperState>(status_->gripper_state), GripperState::kClosed);
  EXPECT_EQ(board_.outputs.gripper_permille, 1000);
  send(Gripper{0});
  run(460);
  EXPECT_EQ(static_cast<GripperState>(status_->gripper_state), GripperState::kOpen);
  send(Gripper{2});
  run(2);
  EXPECT_EQ(result(), Result::kOutOfRange);
}

TEST_F(ControllerOnTheBench, NoPushOfABumperIsTooShortToBeTold) {
  for (int n = 0; n < 8; ++n) {
    run(61 + static_cast<std::uint32_t>(n) * 7);
    EXPECT_EQ(status_->bumpers, 0);
    board_.bumpers = static_cast<std::uint8_t>(1 << n);
    run(2);
    board_.bumpers = 0;
    run(20);
    EXPECT_EQ(status_->bumpers, 1 << n);
  }
}

TEST_F(ControllerOnTheBench, TellsTheBeam) {
  board_.beam_broken = true;
  run(20);
  EXPECT_TRUE(flag(status_flag::kBeamBroken));
  board_.beam_broken = false;
  run(60);
  EXPECT_FALSE(flag(status_flag::kBeamBroken));
}

TEST_F(ControllerOnTheBench, ALineThatTakesNothingHoldsNothingUp) {
  struct Deaf final : Hardware {
    Inputs read() override { return {}; }
    void write(const Outputs&) override {}
    std::size_t receive(std::span<std::uint8_t>) override { return 0; }
    std::size_t send(std::span<const std::uint8_t>) override { return 0; }
  } deaf;
  Controller controller(deaf, {});
  for (std::uint32_t now_ms = 0; now_ms < 5000; ++now_ms) controller.update(now_ms);
}

}  // namespace
}  // namespace galilean::robot::firmware
