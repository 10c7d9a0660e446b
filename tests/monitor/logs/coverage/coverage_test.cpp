// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/coverage/coverage.h"

#include <gmock/gmock.h>

#include "core/json_text.h"
#include "tests/monitor/logs/logged_team.h"

namespace galilean::logs {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A program with three states and three conditions, of which two lead from "wander".
msg::Program fetch() {
  msg::Program program;
  program.name = "fetch";
  program.hash = "3f2a";
  program.start_state = "wander";
  for (const char* name : {"wander", "grab", "flee"}) program.states.emplace_back().name = name;
  const auto add = [&](const char* from, const char* to, std::uint32_t line) {
    auto& condition = program.transitions.emplace_back();
    condition.from_state = from;
    condition.to_state = to;
    condition.file = "fetch.bhdl";
    condition.line = line;
    condition.bits_variable = "bumpers";
    condition.bit_value = true;
  };
  add("wander", "grab", 5);
  add("wander", "flee", 6);
  add("grab", "wander", 9);
  return program;
}

/// The transition by a condition of the program, during which others held, too.
msg::Transition taken(const msg::MachineTransition& by,
                      const std::vector<msg::MachineTransition>& held = {}) {
  msg::Transition transition;
  transition.robot = "io";
  transition.program_hash = "3f2a";
  transition.from_state = by.from_state;
  transition.to_state = by.to_state;
  transition.file = by.file;
  transition.line = by.line;
  transition.bits_variable = by.bits_variable;
  transition.bit_value = by.bit_value;
  for (const auto& other : held) {
    auto& tested = transition.tested.emplace_back();
    tested.to_state = other.to_state;
    tested.file = other.file;
    tested.line = other.line;
    tested.bits_variable = other.bits_variable;
    tested.bit_value = other.bit_value;
    tested.holds = true;
  }
  return transition;
}

class CoverageTest : public LoggedTeam {
 protected:
  CoverageTest() {
    const auto program = fetch();
    expect::RecordedTeam team;
    msg::RobotState state;
    state.robot = "io";
    state.program_hash = program.hash;
    state.state = "wander";
    team.send(0, "/io/state", state);
    team.send(0.1, "/io/transition",
              taken(program.transitions[0], {program.transitions[0], program.transitions[1]}));
    team.send(0.2, "/io/transition", taken(program.transitions[2]));
    team.send(0.3, "/io/program", program);  // it may come late
    write("a.mcap", team.end());
  }
  Answer coverage(CoverageOptions options) const {
    for (auto& file : options.files) file = path(file);
    return answer_of([&] { return print_coverage(options); });
  }
};

TEST_F(CoverageTest, TellsWhatWasNeverDone) {
  const auto answer = coverage({.files = {"a.mcap"}});
  EXPECT_EQ(answer.code, 0) << answer.errors;
  EXPECT_THAT(answer.out, HasSubstr("fetch: 2 of 3 states (67 %), 2 of 3 conditions (67 %)\n"));
  EXPECT_THAT(answer.out, HasSubstr("  never in flee\n"));
  EXPECT_THAT(answer.out,
              HasSubstr("  never taken: fetch.bhdl:6: wander -> flee when bumpers[0] is 1; it held "
                        "1 time while another came first\n"));
  EXPECT_THAT(answer.out, Not(HasSubstr("fetch.bhdl:5")));
}

TEST_F(CoverageTest, AddsUpSeveralRecordings) {
  const auto program = fetch();
  expect::RecordedTeam team;
  team.send(0, "/europa/transition", taken(program.transitions[1]));
  write("b.mcap", team.end());
  const auto answer = coverage({.files = {"a.mcap", "b.mcap"}, .format = "json"});
  EXPECT_EQ(answer.code, 0) << answer.errors;
  const auto json = read_json(answer.out).value()["3f2a"];
  EXPECT_EQ(json["name"], "fetch");
  for (const auto& condition : json["conditions"]) EXPECT_EQ(condition["taken"], 1);
  EXPECT_EQ(json["conditions"][1]["held_behind_another"], 1);
  EXPECT_EQ(json["states"][2]["entered"], 1);
}

TEST_F(CoverageTest, FailsBelowTheShareThatIsWanted) {
  EXPECT_EQ(coverage({.files = {"a.mcap"}, .least_percent = 60}).code, 0);
  const auto answer = coverage({.files = {"a.mcap"}, .least_percent = 70});
  EXPECT_EQ(answer.code, 1);
  EXPECT_THAT(answer.errors, HasSubstr("less than 70 % of fetch was exercised"));
}

TEST_F(CoverageTest, DrawsWhatWasDoneOntoTheStateMachine) {
  const auto answer = coverage({.files = {"a.mcap"}, .format = "dot"});
  EXPECT_THAT(answer.out, HasSubstr("digraph \"fetch\" {"));
  EXPECT_THAT(answer.out, HasSubstr("\"wander\" -> \"grab\" [label=\"1\"];"));
  EXPECT_THAT(answer.out, HasSubstr("\"wander\" -> \"flee\" [style=dashed];"));
  EXPECT_THAT(answer.out, HasSubstr("\"flee\" [style=\"rounded,dashed\"];"));
}

TEST_F(CoverageTest, SaysWhereThereIsNoProgram) {
  write("none.mcap", six_seconds());
  const auto answer = coverage({.files = {"none.mcap"}});
  EXPECT_EQ(answer.code, 1);
  EXPECT_THAT(answer.errors, HasSubstr("no robot of these recordings runs a program"));
}

}  // namespace
}  // namespace galilean::logs
