// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <optional>
#include <random>
#include <vector>

#include "robot/devices/byte_pipe.h"
#include "robot/devices/microcontroller_link.h"
#include "robot/devices/motor_drive.h"
#include "tests/sim/devices/watched_board.h"
#include "tests/sim/scenes.h"

namespace galilean::sim {
namespace {

using robot::firmware::Inputs;

constexpr std::uint32_t kStep_ms = 10;
constexpr std::uint32_t kTick_ms = 50;
constexpr double kFullSpeed_mps = 100 / 325.0;

constexpr std::uint32_t kBrakingWithin_ms = 120;
constexpr std::uint32_t kStillWithin_ms = 300;
constexpr double kWithin_m = 0.05;
constexpr double kStill_mps = 0.002;

/// What becomes of the robot's program or of its line, at a moment that nobody chose.
enum class Fault { kKilled, kFrozen, kHung, kUnplugged, kGarbage, kHalfFrames, kDamaged, kFaults };

/// What was seen from the last good Drive on.
struct Stop {
  std::uint32_t braking_ms = 0;  ///< when no motor was powered ahead any more
  std::uint32_t still_ms = 0;    ///< when wheels and body stood, for good
  double way_m = 0;              ///< that the wheel went which went farther
};

/// What was seen at the end of a step.
struct Step {
  std::uint32_t at_ms = 0;  ///< from the last good Drive on
  Inputs inputs;
  bool slides = false;
};

/// Returns the way of the wheel that went farther.
std::int32_t counts_between(const Inputs& from, const Inputs& to) {
  return std::max(std::abs(to.left_encoder_counts - from.left_encoder_counts),
                  std::abs(to.right_encoder_counts - from.right_encoder_counts));
}

double metres(std::int32_t from_counts, std::int32_t to_counts) {
  return (to_counts - from_counts) / Treads::kCountsPerMetre;
}

/// A robot's devices, as its process has them, before the simulator's firmware and treads.
class Bench {
 public:
  explicit Bench(std::uint32_t seed) : random_(seed) { start_robot(); }

  /// Drives at full speed, straight or on the spot, for a time that varies by a tick.
  void get_to_full_speed() {
    world_->robot(0).place({{3, 3}, 0});
    wanted_ = below(2) == 0 ? DriveCommand{.speed_mps = sign() * kFullSpeed_mps}
                            : DriveCommand{.turn_rate_radps =
                                               sign() * kFullSpeed_mps / Treads::kTurnRadius_m};
    const std::uint32_t until_ms = now_ms_ + 900 + kStep_ms * below(kTick_ms / kStep_ms);
    while (now_ms_ < until_ms) step(true, true);
  }
  [[nodiscard]] double speed_mps() {
    const Inputs before = inputs();
    for (std::uint32_t i = 0; i < kTick_ms / kStep_ms; ++i) step(true, true);
    return std::abs(metres(before.left_encoder_counts, inputs().left_encoder_counts)) * 1000 /
           kTick_ms;
  }
  Stop stop_by(Fault fault) {
    const int left = board_.outputs().left_pwm > 0 ? 1 : -1;
    const int right = board_.outputs().right_pwm > 0 ? 1 : -1;
    if (fault == Fault::kKilled) robot_.reset();
    if (fault == Fault::kUnplugged) line_.connect(false);
    Stop seen;
    bool braking = false;
    std::vector<Step> steps;
    for (int i = 0; i < 45; ++i) {
      suffer(fault);
      step(fault == Fault::kHung || fault == Fault::kUnplugged, fault == Fault::kUnplugged);
      const auto& motors = board_.outputs();
      const bool ahead = motors.left_pwm * left > 0 || motors.right_pwm * right > 0;
      if (ahead) braking = false;
      // The outputs are those of the update at the beginning of the step.
      if (!ahead && !braking) seen.braking_ms = now_ms_ - kStep_ms - board_.last_drive_ms();
      braking = !ahead;
      steps.push_back({now_ms_ - board_.last_drive_ms(), inputs(), slides()});
    }
    // An encoder's last count may still flip where a tread came to rest beside its edge.
    for (const auto& each : steps)
      if (each.slides || counts_between(each.inputs, inputs()) > 1) seen.still_ms = each.at_ms;
    EXPECT_TRUE(braking);
    const Inputs& from = board_.at_last_drive();
    seen.way_m =
        std::max(std::abs(metres(from.left_encoder_counts, inputs().left_encoder_counts)),
                 std::abs(metres(from.right_encoder_counts, inputs().right_encoder_counts)));
    return seen;
  }
  /// Starts the robot's program anew, on a line that is whole.
  void start_robot() {
    robot_.reset();
    line_.connect(true);
    robot_.emplace(line_.robot_end());
  }
  [[nodiscard]] std::uint32_t below(std::uint32_t n) { return random_() % n; }

 private:
  struct Robot {
    explicit Robot(robot::ByteStream& line) : link(line, {}), drive(link, {}) {}
    robot::MicrocontrollerLink link;
    robot::WheelDrive drive;
  };

  [[nodiscard]] int sign() { return below(2) == 0 ? 1 : -1; }
  [[nodiscard]] Inputs inputs() const { return world_->robot(0).inputs(); }

  void step(bool pumps, bool ticks) {
    if (ticks && now_ms_ % kTick_ms == 0) robot_->drive.drive(wanted_);
    if (pumps) robot_->link.pump(Time{std::chrono::milliseconds(now_ms_)});
    board_.update(now_ms_);
    world_->step();
    now_ms_ += kStep_ms;
  }
  [[nodiscard]] bool slides() const {
    const b2Vec2 velocity = world_->robot(0).body().GetLinearVelocity();
    return std::hypot(velocity.x, velocity.y) > kStill_mps;
  }

  /// Writes what the fault puts on the line in this step.
  void suffer(Fault fault) {
    std::array<std::uint8_t, robot::firmware::kMaxEncoded> bytes{};
    const robot::firmware::Drive drive{1600, 1600, 0, 0};
    std::size_t size =
        robot::firmware::encode_message(drive, static_cast<std::uint16_t>(below(65536)), bytes);
    if (fault == Fault::kGarbage) {
      size = below(static_cast<std::uint32_t>(bytes.size()));
      for (auto& byte : bytes) byte = static_cast<std::uint8_t>(below(256));
    } else if (fault == Fault::kHalfFrames) {
      size = below(static_cast<std::uint32_t>(size) - 2) + 1;
    } else if (fault == Fault::kDamaged) {
      bytes[1 + below(static_cast<std::uint32_t>(size) - 2)] ^=
          static_cast<std::uint8_t>(1u << below(8));
    } else {
      return;
    }
    line_.robot_end().write(std::span<const std::uint8_t>(bytes).first(size));
  }

  std::mt19937 random_;
  std::unique_ptr<World> world_ = world_of(bare_floor());
  robot::BytePipe line_{"bench line"};
  WatchedBoard board_{world_->robot(0), line_.board_end()};
  std::optional<Robot> robot_;
  DriveCommand wanted_;
  std::uint32_t now_ms_ = 0;
};

// The promise of docs/SERIAL_PROTOCOL.md: whatever happens above the board, the wheels stand soon.
TEST(StopTimer, TheWheelsStandWhateverBecomesOfTheProgramAndItsLine) {
  constexpr int kTrials = GALILEAN_SANITIZED ? 300 : 10'000;
  Bench bench(4);
  Stop worst;
  for (int trial = 0; trial < kTrials; ++trial) {
    bench.get_to_full_speed();
    ASSERT_NEAR(bench.speed_mps(), kFullSpeed_mps, 0.05 * kFullSpeed_mps) << "trial " << trial;
    const auto fault = static_cast<Fault>(bench.below(static_cast<std::uint32_t>(Fault::kFaults)));
    const Stop stop = bench.stop_by(fault);
    ASSERT_LE(stop.braking_ms, kBrakingWithin_ms) << trial << ", " << static_cast<int>(fault);
    ASSERT_LE(stop.still_ms, kStillWithin_ms) << trial << ", " << static_cast<int>(fault);
    ASSERT_LE(stop.way_m, kWithin_m) << trial << ", " << static_cast<int>(fault);
    worst.braking_ms = std::max(worst.braking_ms, stop.braking_ms);
    worst.still_ms = std::max(worst.still_ms, stop.still_ms);
    worst.way_m = std::max(worst.way_m, stop.way_m);
    bench.start_robot();
  }
  RecordProperty("worst_braking_ms", static_cast<int>(worst.braking_ms));
  RecordProperty("worst_still_ms", static_cast<int>(worst.still_ms));
  RecordProperty("worst_way_mm", static_cast<int>(std::lround(worst.way_m * 1000)));
}

}  // namespace
}  // namespace galilean::sim
