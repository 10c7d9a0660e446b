// SPDX-License-Identifier: BSD-3-Clause
#include "robot/restart/start.h"

#include <gmock/gmock.h>

#include "bhdl/source/sha256.h"
#include "tests/robot/restart/own_program.h"

namespace galilean::robot {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const bhdl::Program& given() {
  static const bhdl::Program program = own_program("given.bhdl", "given");
  return program;
}
const bhdl::Program& other() {
  static const bhdl::Program program = own_program("other.bhdl", "other");
  return program;
}

KeptProgram kept_of(const bhdl::Program& program, bool running, bool pushed) {
  return {.robot = "io",
          .running = running,
          .pushed = pushed,
          .hash = program.hash,
          .files = program.files};
}

Start start_with(const Result<std::optional<KeptProgram>>& kept, bool fresh = false) {
  return choose_start(given(), kept, test_components().catalog(), fresh);
}
Start start_after(const KeptProgram& kept, bool fresh = false) {
  return start_with(std::optional<KeptProgram>(kept), fresh);
}

TEST(Start, TheFirstOneHasNoChoice) {
  const Start start = start_with(std::optional<KeptProgram>());
  EXPECT_EQ(start.program.hash, given().hash);
  EXPECT_EQ(start.last_end, LastEnd::kInOrder);
  EXPECT_EQ(start.sentence, "");
}

TEST(Start, AfterADeathThePushedProgramRunsAgain) {
  const Start start = start_after(kept_of(other(), true, true));
  EXPECT_EQ(start.program.hash, other().hash);
  EXPECT_EQ(start.program.name, "other.bhdl");
  EXPECT_TRUE(start.pushed);
  EXPECT_EQ(start.last_end, LastEnd::kDied);
  EXPECT_THAT(start.sentence, StartsWith("the robot program died while it ran other.bhdl (" +
                                         other().hash.substr(0, 8) + "), which was pushed and "));
  EXPECT_THAT(start.sentence, HasSubstr("and not given.bhdl (" + given().hash.substr(0, 8) + ")"));
  EXPECT_THAT(start.sentence, HasSubstr("--fresh"));
}

TEST(Start, FreshBeginsWithTheGivenOne) {
  const Start start = start_after(kept_of(other(), true, true), true);
  EXPECT_EQ(start.program.hash, given().hash);
  EXPECT_FALSE(start.pushed);
  EXPECT_EQ(start.last_end, LastEnd::kDied);
  EXPECT_THAT(start.sentence, HasSubstr("since --fresh says so"));
}

TEST(Start, WhatNobodyPushedGivesWayToTheGivenOne) {
  const Start start = start_after(kept_of(other(), true, false));
  EXPECT_EQ(start.program.hash, given().hash);
  EXPECT_EQ(start.last_end, LastEnd::kDied);
  EXPECT_THAT(start.sentence, HasSubstr("it runs given.bhdl"));
}

TEST(Start, TheSameProgramStaysAPushedOne) {
  for (const bool pushed : {true, false}) {
    const Start start = start_after(kept_of(given(), true, pushed));
    EXPECT_EQ(start.program.hash, given().hash);
    EXPECT_EQ(start.pushed, pushed);
    EXPECT_EQ(start.last_end, LastEnd::kDied);
    EXPECT_THAT(start.sentence, HasSubstr("it runs that again"));
  }
}

TEST(Start, AfterAnOrderlyEndTheGivenOneRuns) {
  const Start pushed = start_after(kept_of(other(), false, true));
  EXPECT_EQ(pushed.program.hash, given().hash);
  EXPECT_EQ(pushed.last_end, LastEnd::kInOrder);
  EXPECT_THAT(pushed.sentence, HasSubstr("and not other.bhdl"));
  EXPECT_EQ(start_after(kept_of(other(), false, false)).sentence, "");
  EXPECT_EQ(start_after(kept_of(given(), false, true)).sentence, "");
}

TEST(Start, WhatOperatorsOrderedHoldsAfterADeathWhicheverProgramRuns) {
  const KeptOrders orders{"anna", true};
  for (const bhdl::Program* before : {&given(), &other()})
    for (const bool fresh : {true, false}) {
      KeptProgram kept = kept_of(*before, true, true);
      kept.orders = orders;
      EXPECT_EQ(start_after(kept, fresh).orders, orders);
      kept.running = false;
      EXPECT_EQ(start_after(kept, fresh).orders, KeptOrders{}) << "it ended in order";
    }
  EXPECT_EQ(start_with(Error{"x"}).orders, KeptOrders{});
}

TEST(Start, AProgramThatThisReleaseRefusesIsNotTakenUp) {
  KeptProgram broken = kept_of(other(), true, true);
  broken.files[0].text = "state: nmae: \"x\" end\n";
  broken.hash = bhdl::program_hash(broken.files);
  const Start start = start_after(broken);
  EXPECT_EQ(start.program.hash, given().hash);
  EXPECT_EQ(start.last_end, LastEnd::kDied);
  EXPECT_THAT(start.sentence, HasSubstr("has errors in this release (other.bhdl:1: "));
  EXPECT_EQ(start.sentence.find('\n'), std::string::npos);
}

TEST(Start, WhatCannotBeReadIsSaidInOneSentence) {
  const Start start = start_with(Error{"/x/io.json is not what this robot kept: it is cut short"});
  EXPECT_EQ(start.program.hash, given().hash);
  EXPECT_EQ(start.last_end, LastEnd::kUnknown);
  EXPECT_THAT(start.sentence, StartsWith("/x/io.json is not what this robot kept: it is cut "));
  EXPECT_EQ(start.sentence.find('\n'), std::string::npos);
}

}  // namespace
}  // namespace galilean::robot
