// SPDX-License-Identifier: BSD-3-Clause
// Disturbs the serial line between a robot and its board. The input is a row of what happens on
// it, a letter each: see `happen`. Both ends must go on: the motors get no more than full power,
// the robot tells numbers, and whoever is not well says why. A frame that is encoded decodes to the
// same.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <deque>
#include <span>
#include <string>

#include "robot/devices/microcontroller_link.h"
#include "robot/firmware/controller.h"
#include "tests/fuzz/input.h"
#include "tests/robot/firmware/bench_board.h"

namespace {

using namespace galilean;
using namespace galilean::robot;
using namespace std::chrono_literals;
using bhdl::must;

using Bytes = std::span<const std::uint8_t>;
using Queue = std::deque<std::uint8_t>;

/// The robot's end of a line that never closes.
class RobotEnd final : public ByteStream {
 public:
  explicit RobotEnd(Queue& to_board) : to_board_(to_board) {}

  std::size_t read(std::span<std::uint8_t> bytes) override {
    const auto count = std::min(bytes.size(), incoming.size());
    std::copy_n(incoming.begin(), count, bytes.begin());
    incoming.erase(incoming.begin(), incoming.begin() + static_cast<std::ptrdiff_t>(count));
    return count;
  }
  std::size_t write(std::span<const std::uint8_t> bytes) override {
    constexpr std::size_t kMost = 1024;
    const auto count = std::min(bytes.size(), kMost - std::min(kMost, to_board_.size()));
    to_board_.insert(to_board_.end(), bytes.begin(),
                     bytes.begin() + static_cast<std::ptrdiff_t>(count));
    return count;
  }
  void maintain(Time) override {}
  [[nodiscard]] bool is_open() const override { return true; }
  [[nodiscard]] std::string problem() const override { return {}; }
  [[nodiscard]] const std::string& name() const override { return name_; }

  Queue incoming;

 private:
  Queue& to_board_;
  std::string name_ = "a disturbed line";
};

/// Takes the next bytes of the input; zeros behind its end.
class Input {
 public:
  explicit Input(Bytes bytes) : rest_(bytes) {}
  [[nodiscard]] bool ended() const { return rest_.empty(); }
  std::uint8_t byte() {
    if (rest_.empty()) return 0;
    const auto first = rest_.front();
    rest_ = rest_.subspan(1);
    return first;
  }
  Bytes bytes(std::size_t count) {
    const auto some = rest_.first(std::min(count, rest_.size()));
    rest_ = rest_.subspan(some.size());
    return some;
  }

 private:
  Bytes rest_;
};

class DisturbedLine {
 public:
  DisturbedLine() {
    link_.configure({firmware::bench_parameters(500), 325});
    constexpr int kGreeting = 100;
    for (int i = 0; i < kGreeting; ++i) step();
    must(link_.healthy(), "on a quiet line the two find one another");
  }

  /// Lets one thing happen, and then both ends work for a step.
  void happen(Input& input) {
    const char what = static_cast<char>(input.byte());
    if (what == 'r') robot_end_.incoming.push_back(input.byte());
    if (what == 'b') board_.to_board.push_back(input.byte());
    if (what == 'R') put_frame(input, robot_end_.incoming);
    if (what == 'B') put_frame(input, board_.to_board);
    if (what == 'x' && !robot_end_.incoming.empty()) robot_end_.incoming.pop_front();
    if (what == 'X' && !board_.to_board.empty()) board_.to_board.pop_front();
    if (what == 'd') link_.drive(command(input));
    if (what == 's') link_.stop();
    if (what == 'g') link_.command_gripper(GripperCommand::kClose);
    if (what == 'o') link_.command_gripper(GripperCommand::kOpen);
    if (what == 'l') board_.left.blocked = !board_.left.blocked;
    if (what == 'p') board_.bumpers = input.byte();
    step();
  }

 private:
  static firmware::Drive command(Input& input) {
    const auto speed = [&] { return static_cast<std::int16_t>(input.byte() << 8 | input.byte()); };
    firmware::Drive drive;
    drive.left_speed_counts_s = speed();
    drive.right_speed_counts_s = speed();
    drive.left_limit_counts = drive.right_limit_counts = input.byte();
    return drive;
  }
  /// Puts a whole frame on the line: type, length and payload are the input's.
  static void put_frame(Input& input, Queue& to) {
    firmware::Frame frame;
    frame.type = input.byte();
    frame.sequence = input.byte();
    frame.payload = input.bytes(input.byte());
    std::array<std::uint8_t, firmware::kMaxEncoded> out{};
    const auto size = firmware::encode(frame, out);
    must((size == 0) == (frame.payload.size() > firmware::kMaxPayload),
         "what fits into a frame is encoded");
    to.insert(to.end(), out.begin(), out.begin() + static_cast<std::ptrdiff_t>(size));
  }

  void step() {
    now_ += std::chrono::milliseconds(firmware::kStep_ms);
    ms_ += firmware::kStep_ms;
    board_.step(static_cast<double>(firmware::kStep_s));
    controller_.update(ms_);
    robot_end_.incoming.insert(robot_end_.incoming.end(), board_.from_board.begin(),
                               board_.from_board.end());
    board_.from_board.clear();
    link_.pump(now_);
    link_.sense(now_);
    check();
  }
  void check() const {
    must(std::abs(board_.outputs.left_pwm) <= firmware::kFullPwm &&
             std::abs(board_.outputs.right_pwm) <= firmware::kFullPwm,
         "a motor gets full power at most");
    must(board_.outputs.gripper_permille >= 0 && board_.outputs.gripper_permille <= 1000,
         "the gripper stands between its ends");
    const ControllerStatus& status = link_.status();
    must(std::isfinite(status.left_travel_m) && std::isfinite(status.right_travel_m) &&
             std::isfinite(status.left_speed_mps) && std::isfinite(status.right_speed_mps),
         "the robot tells numbers");
  }

  firmware::BenchBoard board_;
  firmware::Controller controller_{board_, {}};
  RobotEnd robot_end_{board_.to_board};
  MicrocontrollerLink link_{robot_end_, {}};
  Time now_{1s};
  std::uint32_t ms_ = 0;
};

/// Decodes the input as it is. Each frame that it holds must be the same when it is encoded and
/// decoded again.
void decode_and_encode(Bytes input) {
  firmware::FrameDecoder decoder;
  for (const auto byte : input) {
    if (!decoder.push(byte)) continue;
    const firmware::Frame frame = decoder.frame();
    must(frame.payload.size() <= firmware::kMaxPayload, "a payload is within its bounds");
    std::array<std::uint8_t, firmware::kMaxEncoded> out{};
    const auto size = firmware::encode(frame, out);
    firmware::FrameDecoder again;
    bool came = false;
    for (const auto each : Bytes(out).first(size)) came = again.push(each) || came;
    must(came && again.rejected() == 0 && again.frame().type == frame.type &&
             again.frame().sequence == frame.sequence &&
             std::ranges::equal(again.frame().payload, frame.payload),
         "a frame that is encoded decodes to the same");
  }
}

/// Makes a frame of the input's bytes, which must come back.
void encode_and_decode(Bytes input) {
  constexpr std::size_t kHeadBytes = 3;
  if (input.size() < kHeadBytes) return;
  const auto payload =
      input.subspan(kHeadBytes, std::min(input.size() - kHeadBytes, firmware::kMaxPayload));
  const auto sequence = static_cast<std::uint16_t>(input[1] << 8 | input[2]);
  std::array<std::uint8_t, firmware::kMaxEncoded> out{};
  const auto size = firmware::encode({input[0], sequence, payload}, out);
  must(size > 0, "what fits into a frame is encoded");
  decode_and_encode(Bytes(out).first(size));
  firmware::FrameDecoder decoder;
  bool came = false;
  for (const auto byte : Bytes(out).first(size)) came = decoder.push(byte) || came;
  must(came && std::ranges::equal(decoder.frame().payload, payload), "a frame comes back");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Bytes input(data, size);
  decode_and_encode(input);
  encode_and_decode(input);
  DisturbedLine line;
  for (Input rest(input); !rest.ended();) line.happen(rest);
  return 0;
}
