// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

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
}

/// The limit: a look at every byte.
void count_lines(benchmark::State& state) {
  const auto text = generated_program(static_cast<int>(state.range()));
  for (auto _ : state) benchmark::DoNotOptimize(std::ranges::count(text, '\n'));
  count(state, text);
}

/// A peer: the same states as JSON.
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

/// Parser, checker and warnings without the limit of a file's size.
void parse_and_check(benchmark::State& state) {
  const auto text = generated_program(static_cast<int>(state.range()));
  for (auto _ : state) {
    Diagnostics diagnostics;
    const CheckedTree checked = check_tree(parse("program.bhdl", text, diagnostics), "program.bhdl",
                                           robot_vocabulary(), diagnostics);
    warn_of_suspects(checked.program, robot_vocabulary(),
                     {checked.tree, checked.bases, checked.unused_constants, "program.bhdl"},
                     diagnostics);
    benchmark::DoNotOptimize(checked);
    if (diagnostics.has_errors()) return state.SkipWithError("the program has errors");
  }
  count(state, text);
}

/// All that a push costs before the program is built: copy, UTF-8, parse, check, SHA-256.
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

/// From the text of fifteen components and two states to a program that can tick.
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

/// The second half of it.
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
