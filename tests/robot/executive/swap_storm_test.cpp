// SPDX-License-Identifier: BSD-3-Clause
// Many swaps in a row, a tenth of them with a fault. GALILEAN_SWAPS says how many;
// docs/RELIABILITY.md tells of 100,000.
#include <malloc.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>

#include "tests/robot/executive/random_robot_program.h"
#include "tests/robot/executive/test_robot.h"

namespace galilean::robot {
namespace {

constexpr Duration kStormPeriod = std::chrono::milliseconds(50);
constexpr Duration kShortProbation = 2 * kStormPeriod;
constexpr Duration kFaultyProbation = 6 * kStormPeriod;  ///< longer than three slow ticks
constexpr std::size_t kPrograms = 32;                    ///< a byte tells them apart
constexpr unsigned long kFewSwaps = 3000;
constexpr int kFaultyOf = 10;
const char* const kThrower = "thrower: name: \"throws\" after: 1 end\n";
/// As many descriptions of programs that are gone are kept at most.
constexpr int kRemembered = 20;
/// What the heap may grow by while programs come and go, since its pieces lie otherwise then.
constexpr std::size_t kMostGrowth_bytes = 128 << 10;

unsigned long swaps_asked_for() {
  const char* const given = std::getenv("GALILEAN_SWAPS");
  const unsigned long asked = given ? std::strtoul(given, nullptr, 10) : kFewSwaps;
  return asked > 0 ? asked : kFewSwaps;
}

std::size_t heap_bytes() {
  const auto heap = mallinfo2();  // zeros under sanitizers, which have a heap of their own
  return heap.uordblks + heap.hblkhd;
}

/// The faults that a swap meets, in turn.
enum class SwapFault {
  kCameraGone,     ///< a device that answered is lost
  kSlow,           ///< ticks take longer than their period
  kThrow,          ///< a schema throws
  kSecondProgram,  ///< another program is loaded while one waits
  kRefused,        ///< the robot does not admit the program
  kTakenOff,       ///< an operator takes the program off in its first tick
  kHeld,           ///< an operator holds the robot meanwhile
  kHowMany
};

/// A robot on which programs are swapped, and the account of it.
class StormedRobot {
 public:
  explicit StormedRobot(unsigned long swaps) {
    RandomRobotProgram random(1);
    for (std::size_t i = 0; i < kPrograms; ++i) programs_.push_back(checked(random.draw(mark(i))));
    for (std::size_t i = 0; i < kPrograms; ++i)
      throwing_.push_back(checked(note_program(mark(i), kThrower)));
    plain_ = checked(note_program(mark(0), ""));
    program_of_.reserve(swaps + 4 * kRemembered);
    program_of_.push_back(0);  // ids begin with 1
    robot_.port.on_sense = [this] { robot_.stopwatch.advance(slowness_); };
    robot_.admits = [this](const bhdl::Program&) {
      return admits_ ? Result<void>() : Result<void>(Error{"the test says so"});
    };
    EXPECT_TRUE(offer(0, programs_[0], kShortProbation));
    tick(3);
  }
  ~StormedRobot() { journal.clear(); }
  StormedRobot(const StormedRobot&) = delete;
  StormedRobot& operator=(const StormedRobot&) = delete;

  void swap(unsigned long number) {
    let_waiting_program_run();
    const std::size_t which = number % kPrograms;
    EXPECT_TRUE(offer(which, programs_[which], kShortProbation)) << number;
    tick(1 + static_cast<int>(number % 4));
    account();
  }

  void swap_with(SwapFault fault, unsigned long number) {
    let_waiting_program_run();
    const std::size_t which = number % kPrograms;
    begin(fault);
    const auto& program = fault == SwapFault::kThrow ? throwing_[which] : programs_[which];
    EXPECT_EQ(offer(which, program, kFaultyProbation), fault != SwapFault::kRefused) << number;
    if (fault == SwapFault::kSecondProgram) {
      EXPECT_FALSE(robot_.executive->load(programs_[0]));
    }
    tick();
    if (fault == SwapFault::kTakenOff)
      robot_.executive->roll_back(robot_.executive->running(), "by the test");
    tick(6);
    end();
    tick(2);
    account();
  }

  /// Lets one and the same program be all that the executive knows, and returns the heap's size.
  [[nodiscard]] std::size_t settled_heap_bytes() {
    for (int i = 0; i < kRemembered; ++i) {
      let_waiting_program_run();
      EXPECT_TRUE(offer(0, plain_, kShortProbation));
      tick(4);
    }
    account();
    robot_.executive->collect();
    return heap_bytes();
  }

  unsigned long ticks = 0;
  unsigned long mixed_ticks = 0;
  int rolled_back = 0;

 private:
  static std::string mark(std::size_t program) { return "program " + std::to_string(program); }
  static bhdl::Program checked(const std::string& text) { return program_of(text); }

  /// Returns a program that notes its mark as random ones do, with one schema more.
  static std::string note_program(const std::string& mark, const std::string& schema) {
    const auto noting = [&](const char* kind, const char* verb, const char* name) {
      return std::string(kind) + ": name: \"" + name + "\" word: \"" + verb + " " + mark +
             "\" end\n";
    };
    const std::string listed = schema.empty() ? "" : "\"throws\" ";
    return "perceptual_schemas:\n" + noting("note", "perceive", "first") + schema +
           noting("note", "perceive", "last") + "end\nmotor_schemas:\n" +
           noting("note_motor", "act", "first") + noting("note_motor", "act", "last") +
           "end\nstate: name: \"a\" perceptual_schemas: \"first\" " + listed +
           "\"last\" end motor_schemas: \"first\" \"last\" end end\n";
  }

  /// Returns whether the robot takes the program, which is to run from the next tick on.
  bool offer(std::size_t which, const bhdl::Program& program, Duration probation) {
    const auto id = robot_.executive->load(
        program, {.length = probation, .most_transitions_per_s = ProbationRules::kMostCounted});
    if (!id) return false;
    program_of_.resize(std::max<std::size_t>(program_of_.size(), id.value() + 1));
    program_of_[id.value()] = static_cast<std::uint8_t>(which);
    return true;
  }

  /// Counts what happened since the last call.
  void account() {
    rolled_back += robot_.events.count(Event::Kind::kRolledBack);
    robot_.events.events.clear();
  }

  void begin(SwapFault fault) {
    if (fault == SwapFault::kCameraGone) robot_.camera.answers = false;
    if (fault == SwapFault::kSlow) slowness_ = 2 * kStormPeriod;
    if (fault == SwapFault::kRefused) admits_ = false;
    if (fault == SwapFault::kHeld) robot_.executive->hold();
  }
  void end() {
    robot_.camera.answers = true;
    slowness_ = Duration::zero();
    admits_ = true;
    robot_.executive->resume();
  }

  void tick(int times = 1) {
    for (int i = 0; i < times; ++i) {
      journal.clear();
      robot_.tick();
      ++ticks;
      if (!of_one_program()) ++mixed_ticks;
    }
  }
  /// A rollback comes first, and what waits runs a tick later.
  void let_waiting_program_run() {
    while (robot_.executive->waiting()) tick();
  }
  /// Returns whether all that ran in this tick belongs to the program that runs now.
  [[nodiscard]] bool of_one_program() const {
    const std::string running = mark(program_of_[robot_.executive->program()->description->id]);
    std::size_t ran = 0;
    for (const std::string& word : journal) {
      if (word[0] == '+') continue;  // it was activated
      if (word != (ran < 2 ? "perceive " : "act ") + running) return false;
      ++ran;
    }
    return ran == 4;
  }

  TestRobot robot_;
  std::vector<bhdl::Program> programs_;
  std::vector<bhdl::Program> throwing_;
  bhdl::Program plain_;
  std::vector<std::uint8_t> program_of_;  ///< by the executive's number of it
  Duration slowness_ = Duration::zero();
  bool admits_ = true;
};

TEST(SwapStorm, NoTickIsMixedAndTheHeapStaysAsItIs) {
  const unsigned long swaps = swaps_asked_for();
  StormedRobot robot(swaps);
  unsigned long faults = 0;
  std::size_t settled_bytes = 0;
  for (unsigned long number = 1; number <= swaps && !HasFailure(); ++number) {
    if (number % kFaultyOf == 0)
      robot.swap_with(static_cast<SwapFault>(faults++ % static_cast<int>(SwapFault::kHowMany)),
                      number);
    else
      robot.swap(number);
    if (number == swaps / 4) settled_bytes = robot.settled_heap_bytes();
  }
  const std::size_t end_bytes = robot.settled_heap_bytes();
  std::cout << swaps << " swaps, " << faults << " with a fault, " << robot.rolled_back
            << " rolled back, " << robot.ticks << " ticks, " << robot.mixed_ticks << " mixed, heap "
            << settled_bytes << " bytes after a quarter, " << end_bytes << " at the end\n";
  EXPECT_EQ(robot.mixed_ticks, 0U);
  EXPECT_GT(robot.rolled_back, 0);
  EXPECT_LT(end_bytes, settled_bytes + kMostGrowth_bytes);
}

}  // namespace
}  // namespace galilean::robot
