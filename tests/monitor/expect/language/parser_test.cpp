// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/language/parser.h"

#include <gmock/gmock.h>

namespace galilean::expect {
namespace {

using testing::HasSubstr;

/// Returns the only diagnostic of a text, as people see it.
std::string complaint(std::string_view text) {
  const auto parsed = parse("a.expect", text);
  if (parsed.diagnostics.size() != 1)
    return std::to_string(parsed.diagnostics.size()) + " diagnostics";
  return bhdl::format(parsed.diagnostics.front());
}

const Claim& only_claim(const Parsed& parsed) {
  return parsed.expectations.at(0).claims.at(0);
}

TEST(ExpectationParser, ReadsWhatTheManualShows) {
  const auto parsed = parse("a.expect", R"(; a comment
every robot: never state is "stuck" for 10 s
io: eventually within 60 s state is "grab_trash"
every robot: after state becomes "grab_trash", within 5 s state is "backup1"
some robot: count of transitions to "drop_trash" >= 3
team: score >= 4 at end
every robot: always certainty of trash <= 1,
  always tick overruns = 0
io: rate of /io/state >= 15 Hz, no gaps longer than 500 ms
)");
  for (const auto& each : parsed.diagnostics) ADD_FAILURE() << bhdl::format(each);
  ASSERT_EQ(parsed.expectations.size(), 7U);
  EXPECT_EQ(std::get<Never>(only_claim(parsed).kind).for_s, 10);
  const auto& after = std::get<After>(parsed.expectations[2].claims.at(0).kind);
  EXPECT_EQ(std::get<Transition>(after.trigger.kind).to, "grab_trash");
  EXPECT_EQ(after.within_s, 5);
  EXPECT_EQ(parsed.expectations[5].claims.size(), 2U);
  EXPECT_EQ(parsed.expectations[5].claims[1].at.line, 8);
  const auto& gaps = std::get<NoGaps>(parsed.expectations[6].claims.at(1).kind);
  EXPECT_EQ(gaps.topic.text, "/io/state");
  EXPECT_EQ(gaps.longest_s, 0.5);
}

TEST(ExpectationParser, ConvertsUnits) {
  const auto parsed = parse("a.expect", "io: always distance of trash < 30 cm");
  ASSERT_TRUE(parsed.ok());
  const auto& always = std::get<Always>(only_claim(parsed).kind);
  EXPECT_DOUBLE_EQ(std::get<Comparison>(always.condition.kind).limit, 0.3);
  const auto percent = parse("a.expect", "io: always certainty of trash >= 20 %");
  ASSERT_TRUE(percent.ok());
  const auto& more = std::get<Always>(only_claim(percent).kind);
  EXPECT_DOUBLE_EQ(std::get<Comparison>(more.condition.kind).limit, 0.2);
}

TEST(ExpectationParser, SaysWhatWasExpectedAndMeant) {
  EXPECT_EQ(complaint("io: nevr state is \"a\""),
            "a.expect:1:5: error: expected a claim, not 'nevr'\n  hint: did you mean 'never'?");
  EXPECT_EQ(complaint("io: always stat is \"a\""),
            "a.expect:1:12: error: 'stat' is not compared with a name; state, program, phase and "
            "fields are\n  hint: did you mean 'state'?");
  EXPECT_EQ(complaint("evry robot: always tick overruns = 0"),
            "a.expect:1:6: error: expected ':' behind 'evry', not 'robot'\n"
            "  hint: did you mean 'every'?");
  EXPECT_EQ(complaint("io: eventually within 60 sec state is \"a\""),
            "a.expect:1:26: error: there is no unit 'sec'\n  hint: did you mean 's'?");
  EXPECT_EQ(complaint("io: always distance of trash < 3 s"),
            "a.expect:1:34: error: 's' is a unit of time; distance is length\n"
            "  hint: its units are m, cm, mm, in, ft");
  EXPECT_EQ(complaint("io: never state is \"a\" for 10"),
            "a.expect:1:28: error: '10' has no unit: a time is in s, ms, min\n"
            "  hint: did you mean '10 s'?");
  EXPECT_EQ(complaint("team: always state is \"a\""),
            "a.expect:1:14: error: 'state' is of a robot, and the team has none\n"
            "  hint: begin with 'every robot:', 'some robot:' or a robot's name");
  EXPECT_EQ(complaint("always state is \"a\""),
            "a.expect:1:1: error: the claim is about nobody\n"
            "  hint: say whom it is about first: 'every robot:', 'team:' or 'io:'");
  EXPECT_EQ(complaint("io: always certanty of trash < 1"),
            "a.expect:1:12: error: there is nothing to measure that is called 'certanty'\n"
            "  hint: did you mean 'certainty'?");
  EXPECT_THAT(complaint("# io"), HasSubstr("a comment begins with ;"));
}

TEST(ExpectationParser, GoesOnBehindAMistake) {
  const auto parsed = parse("a.expect",
                            "io: always x < 3 s, never it is hold, always y < 1 m\n"
                            "io: rate of /io/state >= 15\n"
                            "io: always it is healthy\n");
  ASSERT_EQ(parsed.diagnostics.size(), 3U);
  EXPECT_EQ(parsed.diagnostics[0].column, 18);
  EXPECT_EQ(parsed.diagnostics[1].column, 33);
  EXPECT_THAT(parsed.diagnostics[1].hint, HasSubstr("held"));
  EXPECT_EQ(parsed.diagnostics[2].line, 2);
  EXPECT_EQ(parsed.expectations.size(), 1U);
}

TEST(ExpectationParser, RefusesNumbersThatAreNone) {
  EXPECT_THAT(complaint("io: always x < nan"), HasSubstr("expected x, such as 3 m, not 'nan'"));
  EXPECT_THAT(complaint("io: always x < 1e999 m"), HasSubstr("too large"));
  EXPECT_THAT(complaint("io: never state is \"a\" for 0 s"), HasSubstr("a time is above 0"));
  EXPECT_THAT(complaint("io: never state is \"a\" for 1e300 s"), HasSubstr("at most 30 years"));
  EXPECT_THAT(complaint("io: count of transitions >= 1.5"), HasSubstr("whole number"));
}

TEST(ExpectationParser, RefusesTextsOfNoise) {
  EXPECT_THAT(complaint("io: always state is \"\xFF\""), HasSubstr("not UTF-8"));
  EXPECT_THAT(complaint(std::string("io\0:", 4)), HasSubstr("not a text"));
  EXPECT_THAT(complaint(std::string(10'000'000, 'a')), HasSubstr("at most 1048576"));
  EXPECT_THAT(complaint(""), HasSubstr("expects nothing"));
}

TEST(ExpectationParser, BoundsDepthAndLength) {
  const std::string deep = "io: always " + std::string(100'000, '(') + "x < 1 m";
  EXPECT_THAT(complaint(deep), HasSubstr("64 deep"));
  std::string lengthy = "io: always x < 1 m";
  for (int i = 0; i < 20'000; ++i) lengthy += " and x < 1 m";
  EXPECT_THAT(complaint(lengthy), HasSubstr("at most 1000 conditions"));
  std::string twice = "io: always ";
  for (int i = 0; i < 100'000; ++i) twice += "not ";
  EXPECT_TRUE(parse("a.expect", twice + "x < 1 m").ok());
}

TEST(ExpectationParser, KeepsAHundredMistakes) {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += "io: always\n";
  const auto parsed = parse("a.expect", text);
  EXPECT_EQ(parsed.diagnostics.size(), bhdl::Diagnostics::kMost + 1);
}

}  // namespace
}  // namespace galilean::expect
