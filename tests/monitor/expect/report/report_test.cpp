// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/report/report.h"

#include <gmock/gmock.h>

#include "core/json_text.h"
#include "monitor/expect/report/words.h"

namespace galilean::expect {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr std::int64_t kBegin_ns = 1'700'000'000'000'000'000;

Verdict verdict(Outcome outcome, const std::string& text) {
  Verdict verdict{"io", "io", text, {"a<b.expect", 3, 5}, {}, unit::kSecond};
  verdict.finding.outcome = outcome;
  return verdict;
}

/// One of each outcome. What comes from programs and recordings tries to break out of its place.
Judgement judgement() {
  Judgement judgement{{}, kBegin_ns, kBegin_ns + 60'000'000'000, {"two\nlines"}};
  auto& verdicts = judgement.verdicts;
  verdicts.push_back(verdict(Outcome::kHolds, "eventually within 5 s state is \"a\""));
  verdicts.back().finding.margin = 2;
  verdicts.push_back(verdict(Outcome::kFails, "never state is \"<&>#\" for 3 s"));
  verdicts.back().finding.margin = -1;
  verdicts.back().finding.failures = 2;
  verdicts.back().finding.counterexamples = {
      {kBegin_ns + 12'300'000'000, "state is '\x1b[2J%\n::error::'", {}}};
  verdicts.push_back(verdict(Outcome::kCannotTell, "always it is healthy"));
  verdicts.back().finding.reason = "io was never heard";
  return judgement;
}

TEST(Report, TellsPeopleWhereWhatAndHowToSeeIt) {
  const auto all = judgement();
  const auto text = text_report({"my run.mcap", all});
  EXPECT_THAT(text, HasSubstr("ok     io: eventually within 5 s state is \"a\" (2 s to spare)\n"));
  EXPECT_THAT(text, HasSubstr("FAILS  io: never state is \"<&>#\" for 3 s (missed by 1 s)\n"));
  EXPECT_THAT(text, HasSubstr("at 12.300 s (2023-11-14T22:13:32.300Z): state is 'U+001B[2J%"));
  EXPECT_THAT(text, HasSubstr("; 2 times in all\n"));
  EXPECT_THAT(text, HasSubstr("galilean replay 'my run.mcap' --from 10.300, and on the monitor's "
                              "page: /?robot=io&at=2023-11-14T22:13:32.300Z\n"));
  EXPECT_THAT(text, HasSubstr("cannot tell: io was never heard\n"));
  EXPECT_THAT(text, HasSubstr("1 holds, 1 does not hold, 1 cannot be told\n"));
  EXPECT_THAT(text, Not(HasSubstr("\x1b")));
}

TEST(Report, AMarginOfNothingHasNoSignAndAValueIsToldOnce) {
  auto all = judgement();
  all.verdicts[1].finding.margin = 0;
  auto& finding = all.verdicts[1].finding;
  finding.counterexamples[0].values = finding.note = "rate is 3 Hz";
  const auto text = text_report({"run.mcap", all});
  EXPECT_THAT(text, HasSubstr("(missed by 0 s)"));
  EXPECT_THAT(text, HasSubstr("rate is 3 Hz; 2 times in all\n"));
}

TEST(Report, JUnitCountsWhatCannotBeToldAsAnError) {
  const auto all = judgement();
  const auto text = junit_report({"run.mcap", all});
  EXPECT_THAT(text, HasSubstr("tests=\"3\" failures=\"1\" errors=\"1\""));
  EXPECT_THAT(text, HasSubstr("name=\"io: never state is &quot;&lt;&amp;&gt;#&quot; for 3 s\""));
  EXPECT_THAT(text, HasSubstr("<error message=\"cannot tell: io was never heard\""));
  EXPECT_THAT(text, HasSubstr("file=\"a&lt;b.expect\" line=\"3\""));
  EXPECT_THAT(text, Not(HasSubstr("\x1b")));
}

TEST(Report, TapHidesNoTestBehindADirective) {
  const auto all = judgement();
  const auto text = tap_report({"run.mcap", all});
  EXPECT_TRUE(text.starts_with("TAP version 13\n1..3\nok 1 - io: "));
  EXPECT_THAT(text, HasSubstr("not ok 2 - io: never state is \"<&>\\#\" for 3 s\n"));
  EXPECT_THAT(text, HasSubstr("not ok 3 - io: always it is healthy\n"));
}

TEST(Report, GitHubAnnotatesOneLineAVerdict) {
  const auto all = judgement();
  const auto text = github_report({"run.mcap", all});
  EXPECT_TRUE(text.starts_with("::error file=a<b.expect,line=3,col=5,title="));
  EXPECT_THAT(text, Not(HasSubstr("\n::error::'")));
  EXPECT_THAT(text, HasSubstr("::notice::1 holds, 1 does not hold, 1 cannot be told\n"));
}

TEST(Report, JsonHasEveryValue) {
  const auto all = judgement();
  const auto json = read_json(json_report({"run.mcap", all}));
  ASSERT_TRUE(json.ok());
  EXPECT_EQ(json.value()["fails"], 1);
  const auto& failed = json.value()["verdicts"][1];
  EXPECT_EQ(failed["margin"]["value"], -1.0);
  EXPECT_EQ(failed["counterexamples"][0]["seconds"], 12.3);
  EXPECT_EQ(failed["replay"], "galilean replay run.mcap --from 10.300");
  EXPECT_EQ(failed["page"], "/?robot=io&at=2023-11-14T22:13:32.300Z");
  EXPECT_EQ(json.value()["verdicts"][2]["reason"], "io was never heard");
}

TEST(Report, OfALiveTeamThereIsNothingToReplay) {
  auto all = judgement();
  all.verdicts[1].robot = "io&at=";
  const Report report{"the live team", all, true};
  EXPECT_THAT(text_report(report), HasSubstr("to see it: on the monitor's page: "
                                             "/?robot=io%26at%3D&at=2023-11-14T22:13:32.300Z\n"));
  const auto json = read_json(json_report(report));
  ASSERT_TRUE(json.ok());
  EXPECT_TRUE(json.value()["recording"].is_null());
  EXPECT_FALSE(json.value()["verdicts"][1].contains("replay"));
}

}  // namespace
}  // namespace galilean::expect
