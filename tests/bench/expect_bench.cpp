// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include "monitor/expect/judge/judge.h"
#include "monitor/expect/language/parser.h"
#include "monitor/expect/recording/play_samples.h"
#include "monitor/mcap/message_reader.h"
#include "tests/monitor/expect/recording/recorded_team.h"

namespace {

using namespace galilean;
using namespace galilean::expect;

constexpr const char* kExpectations = R"(
every robot: never state is "stuck" for 10 s
every robot: eventually within 60 s state is "grab_trash"
every robot: after state becomes "grab_trash", within 5 s state is "backup1"
some robot: count of transitions to "drop_trash" >= 0
every robot: always certainty of v3 <= 1, always tick overruns = 0
every robot: rate of ~/state >= 5 Hz, no gaps longer than 500 ms
)";
constexpr int kRobots = 3, kVariables = 24, kPeriods = 6000;
constexpr double kWanted_messages_per_s = 200'000;

/// Ten minutes of three robots: a state and two dozen variables each, ten times a second.
const mcap::Bytes& recording() {
  static const mcap::Bytes bytes = [] {
    RecordedTeam team;
    for (int i = 0; i < kPeriods; ++i)
      for (int robot = 0; robot < kRobots; ++robot) {
        msg::RobotState state;
        state.robot = "robot_" + std::to_string(robot);
        state.program_name = "office_cleanup.bhdl";
        state.program_hash = std::string(64, 'a');
        state.state = i / 50 % 2 ? "wander_for_trash" : "move_to_trash";
        state.tick = static_cast<std::uint64_t>(i);
        team.send(0.1 * i, "/" + state.robot + "/state", state);
        msg::Variables variables;
        variables.robot = state.robot;
        for (int v = 0; v < kVariables; ++v) {
          auto& item = variables.items.emplace_back();
          item.name = "v" + std::to_string(v);
          item.type = msg::Variable_Constants::LOCATE;
          item.valid = true;
          item.certainty = 0.9F;
          item.decay_per_s = 0.02F;
          item.values = {1, 2, 0.1, 0, 0.1, 0.1};
        }
        team.send(0.1 * i, "/" + state.robot + "/variables", variables);
      }
    return team.end();
  }();
  return bytes;
}

/// Reads, decodes and judges. The rate is in messages.
void judge_recording(benchmark::State& state) {
  const mcap::MemorySource source(recording());
  const auto summary = mcap::summarize(source);
  const auto parsed = parse("bench.expect", kExpectations);
  std::uint64_t messages = 0;
  for (auto _ : state) {
    Judge judge(parsed.expectations);
    const auto played = play_samples(source, summary.value(), judge);
    benchmark::DoNotOptimize(judge.finish(played.begin_ns, played.end_ns));
    messages += played.messages;
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(messages));
  state.counters["of_wanted"] = benchmark::Counter(
      static_cast<double>(messages) / kWanted_messages_per_s, benchmark::Counter::kIsRate);
}
BENCHMARK(judge_recording)->Unit(benchmark::kMillisecond);

/// What reading alone takes of it.
void read_recording(benchmark::State& state) {
  const mcap::MemorySource source(recording());
  const auto summary = mcap::summarize(source);
  std::uint64_t messages = 0;
  for (auto _ : state) {
    mcap::MessageReader reader(source, summary.value().blocks);
    while (reader.next() != nullptr) ++messages;
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(messages));
}
BENCHMARK(read_recording)->Unit(benchmark::kMillisecond);

/// A large file of expectations.
void read_expectations(benchmark::State& state) {
  std::string text;
  while (text.size() < 500'000) text += kExpectations;
  for (auto _ : state) benchmark::DoNotOptimize(parse("bench.expect", text));
  state.SetBytesProcessed(static_cast<std::int64_t>(text.size() * state.iterations()));
}
BENCHMARK(read_expectations)->Unit(benchmark::kMillisecond);

}  // namespace
