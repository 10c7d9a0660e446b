// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/coverage/coverage.h"

#include <gmock/gmock.h>

#include "core/json_text.h"
#include "tests/monitor/coverage/fetch_program.h"
#include "tests/monitor/logs/logged_team.h"

namespace galilean::logs {
namespace {

using testing::HasSubstr;
using testing::Not;

class CoverageTest : public LoggedTeam {
 protected:
  CoverageTest() { write("a.mcap", monitor::recording_of_fetch()); }
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
  const auto program = monitor::fetch();
  expect::RecordedTeam team;
  team.send(0, "/europa/transition", monitor::taken(program.transitions[1]));
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
