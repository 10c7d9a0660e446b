// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <ctime>
#include <nlohmann/json.hpp>

#include "bhdl/check.h"
#include "bhdl/check/checker.h"
#include "bhdl/lint/program_check.h"
#include "bhdl/syntax/lexer.h"
#include "bhdl/syntax/parser.h"
#include "robot/executive/builder.h"
#include "tests/bench/generated_program.h"
#include "tests/robot/executive/test_robot.h"

namespace galilean::bhdl {
namespace {

const Vocabulary& robot_vocabulary() {
  static const Vocabulary vocabulary(robot::test_components().catalog());
  return vocabulary;
}

void count(benchmark::State& state, const std::string& text) {
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations() * text.size()));
  // One second for a gigabyte is one nanosecond for a byte.
  constexpr double kGigabyte = 1e9;
  state.counters["a_gigabyte"] =
      benchmark::Counter(static_cast<double>(state.iterations() * text.size()) / kGigabyte,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// The lower limit: one look at every byte.
void count_lines(benchmark::State& state) {
  const auto text = generated_program(static_cast<int>(state.range()));
  for (auto _ : state) benchmark::DoNotOptimize(std::ranges::count(text, '\n'));
  count(state, text);
}

/// For comparison: the same states as JSON.
void parse_json(benchmark::State& state) {
  const auto text = generated_json(static_cast<int>(state.range()));
  for (auto _ : state) benchmark::DoNotOptimize(nlohmann::json::parse(text));
  count(state, text);
}

void lex(benchmark::State& state) {
  const auto text = generated_program(static_cast<int>(state.range()));
  for (auto _ : state) {
    Diagnostics diagnostics;
    Lexer lexer("program.bhdl", text, diagnostics);
    while (lexer.next().kind != TokenKind::kEndOfFile) continue;
  }
  count(state, text);
}

void parse(benchmark::State& state) {
  const auto text = generated_program(static_cast<int>(state.range()));
  for (auto _ : state) {
    Diagnostics diagnostics;
    benchmark::DoNotOptimize(parse("program.bhdl", text, diagnostics));
  }
  count(state, text);
}

/// Parses, checks and warns without the limit of a file's size.
void parse_and_check(benchmark::State& state) {
  const auto text = generated_program(static_cast<int>(state.range()));
  for (auto _ : state) {
    Diagnostics diagnostics;
    const CheckedTree checked = check_tree(parse("program.bhdl", text, diagnostics), "program.bhdl",
                                           robot_vocabulary(), diagnostics);
    warn_of_suspects(checked.program, robot_vocabulary(),
                     {checked.tree, checked.extended, checked.unused_constants, "program.bhdl"},
                     diagnostics);
    benchmark::DoNotOptimize(checked);
    if (diagnostics.has_errors()) return state.SkipWithError("the program has errors");
  }
  count(state, text);
}

/// Does all that a push costs before the program is built: copy, UTF-8, parse, check, SHA-256.
void check_as_pushed(benchmark::State& state) {
  const std::vector<SourceFile> files{
      {"program.bhdl", generated_program(static_cast<int>(state.range()))}};
  for (auto _ : state)
    if (!check(files, robot_vocabulary()).program) return state.SkipWithError("refused");
  count(state, files.front().text);
}

void sizes(benchmark::internal::Benchmark* run) {
  for (const int states : {1, 100, 1000, 10000}) run->Arg(states);
  run->ArgName("states")->Unit(benchmark::kMicrosecond);
}
BENCHMARK(count_lines)->Apply(sizes);
BENCHMARK(parse_json)->Apply(sizes);
BENCHMARK(lex)->Apply(sizes);
BENCHMARK(parse)->Apply(sizes);
BENCHMARK(parse_and_check)->Apply(sizes);
BENCHMARK(check_as_pushed)->ArgName("states")->Arg(1)->Arg(1000)->Unit(benchmark::kMicrosecond);

void parse_once(const std::string& text) {
  Diagnostics diagnostics;
  benchmark::DoNotOptimize(parse("program.bhdl", text, diagnostics));
}

void parse_and_check_once(const std::string& text) {
  Diagnostics diagnostics;
  benchmark::DoNotOptimize(check_tree(parse("program.bhdl", text, diagnostics), "program.bhdl",
                                      robot_vocabulary(), diagnostics));
}

/// Compares the time for a byte of 10,000 states with that of 1,000 states. 1 means linear.
void cost_of_a_byte_at_ten_times_the_states(benchmark::State& state,
                                            void (*work)(const std::string&)) {
  constexpr int kTimes = 10;
  const auto small = generated_program(1000);
  const auto large = generated_program(1000 * kTimes);
  std::clock_t of_small = 0;
  std::clock_t of_large = 0;
  for (auto _ : state) {
    const std::clock_t begin = std::clock();
    for (int i = 0; i < kTimes; ++i) work(small);
    const std::clock_t middle = std::clock();
    work(large);
    of_small += middle - begin;
    of_large += std::clock() - middle;
  }
  const double bytes = static_cast<double>(large.size()) / static_cast<double>(small.size());
  state.counters["ratio"] =
      static_cast<double>(of_large) * kTimes / (static_cast<double>(of_small) * bytes);
}
BENCHMARK_CAPTURE(cost_of_a_byte_at_ten_times_the_states, parse, parse_once)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(cost_of_a_byte_at_ten_times_the_states, parse_and_check, parse_and_check_once)
    ->Unit(benchmark::kMillisecond);

/// Goes from the text of fifteen components and two states to a program that can tick.
void check_and_build(benchmark::State& state) {
  const std::vector<SourceFile> files{{"program.bhdl", generated_program(2)}};
  robot::ScriptedPort port;
  robot::ScriptedDrive drive;
  robot::ScriptedCamera camera;
  const Devices devices{port, drive, camera};
  const robot::BuildMaterial material{robot::test_components(), devices, Random(1)};
  for (auto _ : state) {
    auto checked = check(files, robot_vocabulary());
    if (!checked.program) return state.SkipWithError("refused");
    if (!robot::build(std::move(*checked.program), 1, material))
      return state.SkipWithError("not built");
  }
  count(state, files.front().text);
}
BENCHMARK(check_and_build)->Unit(benchmark::kMicrosecond);

/// Does only the second half of it.
void build_alone(benchmark::State& state) {
  robot::ScriptedPort port;
  robot::ScriptedDrive drive;
  robot::ScriptedCamera camera;
  const Devices devices{port, drive, camera};
  const robot::BuildMaterial material{robot::test_components(), devices, Random(1)};
  const auto program = robot::program_of(generated_program(2));
  for (auto _ : state) benchmark::DoNotOptimize(robot::build(program, 1, material));
}
BENCHMARK(build_alone)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace galilean::bhdl
