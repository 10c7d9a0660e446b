// SPDX-License-Identifier: BSD-3-Clause
#include <map>

#include "tests/robot/executive/random_robot_program.h"
#include "tests/robot/executive/test_robot.h"

namespace galilean::robot {
namespace {

constexpr Duration kPeriod = std::chrono::milliseconds(50);

/// What a variable holds, by its name and type. Of a picture its number will do.
struct Content {
  std::array<double, 6> values{};
  double certainty = 0;
  bool valid = false;
  bool parameter = false;
  bool operator==(const Content&) const = default;
};
using Contents = std::map<std::string, Content>;

std::array<double, 6> values_of(const Shaft& shaft) {
  const auto& pose = shaft.pose;
  return {pose.position_m.x(), pose.position_m.y(), pose.heading_rad, shaft.speed_mps,
          shaft.turn_rate_radps};
}
std::array<double, 6> values_of(const Image& image) {
  return {static_cast<double>(image.frame)};
}
std::array<double, 6> values_of(const Locate& locate) {
  return {locate.position_m.x(), locate.position_m.y(), locate.covariance_m2(0, 0),
          locate.covariance_m2(1, 1), locate.radius_m};
}
std::array<double, 6> values_of(const Bits& bits) {
  return {static_cast<double>(bits.value)};
}
std::array<double, 6> values_of(const Force& force) {
  return {force.value.x(), force.value.y()};
}

Contents contents_of(const RunningProgram& program, Time now) {
  Contents contents;
  std::size_t index = 0;
  program.variables.for_each([&]<class T>(const Variable<T>& each) {
    const bool parameter = program.description->variables[index++].parameter;
    contents[std::string(variable_type_name<T>()) + " " + each.name] = {
        values_of(each.value), each.certainty_at(now), each.valid_at(now), parameter};
  });
  return contents;
}

/// A robot that programs are swapped on, with what must hold in every tick. The port's `sense`
/// comes right after programs were exchanged, before anything is written: there both are compared.
class WatchedRobot {
 public:
  explicit WatchedRobot(std::uint64_t seed) : programs_(seed) {
    robot_.port.on_sense = [this] { compare_programs(); };
    load();
  }
  ~WatchedRobot() { journal.clear(); }

  void load() {
    while (robot_.executive->waiting() && marks_.size() > 1) tick();
    const std::string mark = "program " + std::to_string(marks_.size() + 1);
    const auto program = program_of(programs_.draw(mark));
    const auto id = robot_.executive->load(
        program, {.length = kPeriod * (5 + programs_.below(40)), .most_transitions_per_s = 15});
    ASSERT_TRUE(id);
    marks_[id.value()] = mark;
  }

  void tick() {
    disturb();
    note_before();
    journal.clear();
    const int commands = robot_.drive.commands;
    robot_.tick();
    if (robot_.drive.commands != commands) last_command_ = robot_.now();
    expect_one_whole_program();
    expect_motors_within_timeout();
  }

  void tick(std::uint32_t times) {
    for (std::uint32_t i = 0; i < times && !testing::Test::HasFailure(); ++i) tick();
  }

  RandomRobotProgram& random() { return programs_; }
  const EventList& events() const { return robot_.events; }
  int swaps_compared = 0;

 private:
  /// What happens around a robot; rarely so bad that it may not drive.
  void disturb() {
    robot_.port.next.bumpers = programs_.chance(3) ? std::uint8_t(programs_.below(256)) : 0;
    robot_.port.next.beam_broken = programs_.chance(2);
    robot_.port.next.left_travel_m += programs_.below(10) * 0.01;
    robot_.port.next.right_travel_m += programs_.below(10) * 0.01;
    if (programs_.chance(10)) ++robot_.camera.picture.number;
    robot_.camera.answers = !programs_.chance(60);
    if (programs_.chance(40)) robot_.executive->hold();
    if (programs_.chance(5)) robot_.executive->resume();
  }

  void note_before() {
    const RunningProgram* program = robot_.executive->program();
    if (!program) return;
    ran_before_ = program->description->id;
    state_before_ = program->state_name();
    contents_before_ = contents_of(*program, robot_.now() + kPeriod);
  }

  void compare_programs() {
    const RunningProgram& running = *robot_.executive->program();
    const bool exchanged = ran_before_ != 0 && running.description->id != ran_before_;
    if (!exchanged) return;
    ++swaps_compared;
    for (const auto& [name, content] : contents_of(running, robot_.now())) {
      const auto before = contents_before_.find(name);
      if (before == contents_before_.end()) continue;
      if (before->second.parameter && content.parameter) continue;
      EXPECT_EQ(content.values, before->second.values) << name;
      EXPECT_EQ(content.valid, before->second.valid) << name;
      EXPECT_NEAR(content.certainty, before->second.certainty, 1e-9) << name;
    }
    expect_right_state(running);
  }

  void expect_right_state(const RunningProgram& running) {
    const bool returned = running.description->id < ran_before_;
    const auto& mapping = running.text().on_swap;
    if (running.text().find_state(state_before_)) {
      EXPECT_EQ(running.state_name(), state_before_);
    } else if (const auto mapped = mapping.find(state_before_); mapped != mapping.end()) {
      EXPECT_EQ(running.state_name(), mapped->second);
    } else if (!returned) {
      EXPECT_EQ(running.state_name(), running.text().start_state);
    }
  }

  void expect_one_whole_program() {
    std::erase_if(journal, [](const std::string& word) { return word[0] == '+'; });
    const auto& mark = marks_[robot_.executive->program()->description->id];
    const std::string perceive = "perceive " + mark;
    const std::string act = "act " + mark;
    EXPECT_EQ(journal, (std::vector<std::string>{perceive, perceive, act, act}));
  }

  void expect_motors_within_timeout() const {
    if (!robot_.drive.moving) return;
    const double timeout_s = robot_.executive->program()->devices.motor_drive.timeout_s;
    EXPECT_LT(robot_.now() - last_command_, from_seconds(timeout_s));
    EXPECT_FALSE(robot_.executive->held());
  }

  RandomRobotProgram programs_;
  TestRobot robot_;
  std::map<ProgramId, std::string> marks_;
  ProgramId ran_before_ = 0;
  std::string state_before_;
  Contents contents_before_;
  Time last_command_{};
};

TEST(SwapProperty, AnyPairOfProgramsAtAnyTick) {
  constexpr std::uint64_t kPairs = 400;
  int swaps = 0;
  int rollbacks = 0;
  for (std::uint64_t seed = 1; seed <= kPairs && !testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    WatchedRobot robot(seed);
    robot.tick(1 + robot.random().below(25));
    robot.load();
    robot.tick(1 + robot.random().below(40));
    swaps += robot.swaps_compared;
    rollbacks += robot.events().count(Event::Kind::kRolledBack);
  }
  EXPECT_GE(swaps, 400);
  EXPECT_GT(rollbacks, 20) << "the programs are to fail now and then";
}

TEST(SwapProperty, AnyNumberOfProgramsInARow) {
  for (std::uint64_t seed = 1001; seed <= 1010 && !testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    WatchedRobot robot(seed);
    for (int i = 0; i < 40 && !testing::Test::HasFailure(); ++i) {
      robot.tick(1 + robot.random().below(8));
      robot.load();
    }
    robot.tick(30);
  }
}

}  // namespace
}  // namespace galilean::robot
