// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/push/push_words.h"

#include <gtest/gtest.h>

namespace galilean::monitor::top {
namespace {

using nlohmann::json;
using Stage = PushReport::Stage;

std::string text_of(const PushReport& report) {
  std::string text = report.title + "\n";
  for (const auto& line : report.lines) text += line.text + "\n";
  return text;
}

TEST(PushWords, ACheckTellsTheDifferences) {
  const auto report = report_of_check(json{{"ok", true},
                                           {"hash", "3f2a91c0deadbeef"},
                                           {"diagnostics", json::array()},
                                           {"changes", {"+ state 'spin'", "- state 'rest'"}}},
                                      "office.bhdl");
  EXPECT_EQ(report.stage, Stage::kReady);
  EXPECT_EQ(text_of(report),
            "Push office.bhdl 3f2a91c0\n2 differences from what runs now:\n  + state 'spin'\n"
            "  - state 'rest'\n");
  EXPECT_EQ(report.lines[1].style, Style::kGood);
  const auto same = report_of_check(json{{"ok", true}, {"changes", json::array()}}, "a.bhdl");
  EXPECT_EQ(same.lines[0].text, "It does the same as what runs now.");
}

TEST(PushWords, ErrorsAreToldWithTheirPlaceAndNothingIsPushed) {
  const json error{{"file", "a.bhdl"},
                   {"line", 3},
                   {"column", 5},
                   {"severity", "error"},
                   {"message", "no such schema"},
                   {"hint", "avoid"}};
  const auto report = report_of_check(json{{"ok", false}, {"diagnostics", {error}}}, "a.bhdl");
  EXPECT_EQ(report.stage, Stage::kRefused);
  EXPECT_EQ(text_of(report),
            "Nothing was pushed: a.bhdl has errors\na.bhdl:3:5: error: no such schema\n"
            "  hint: avoid\n");
  EXPECT_EQ(report.lines[0].style, Style::kAlarm);
}

TEST(PushWords, APushTellsItsStepsAndTheAnswers) {
  const auto report = report_of_push(
      json{{"state", "failed"},
           {"program", "office.bhdl"},
           {"hash", "3f2a91c0deadbeef"},
           {"steps",
            {{{"name", "check"}, {"state", "done"}, {"detail", ""}},
             {{"name", "try"}, {"state", "left_out"}, {"detail", ""}},
             {{"name", "canary"}, {"state", "failed"}, {"detail", "io went back"}}}},
           {"replies", {{{"robot", "io"}, {"status", "rolled_back"}, {"message", "too slow"}}}}});
  EXPECT_EQ(report.stage, Stage::kFailed);
  EXPECT_EQ(text_of(report),
            "Push of office.bhdl 3f2a91c0: failed\ncheck  done  \ncanary  failed  io went back\n"
            "  io  rolled_back  too slow\n");
  EXPECT_EQ(report_of_push(json{{"state", "running"}}).stage, Stage::kPushing);
  EXPECT_EQ(report_of_push(json{{"state", "done"}}).stage, Stage::kDone);
}

TEST(PushWords, WhatHistoryDoesNotHoldYetIsTold) {
  const auto report = report_of_push(json{{"id", "7"},
                                          {"program", "office.bhdl"},
                                          {"hash", "3f2a91c0"},
                                          {"state", "done"},
                                          {"not_kept", "the disk is full"}});
  EXPECT_EQ(report.stage, Stage::kDone);
  EXPECT_EQ(text_of(report),
            "Push of office.bhdl 3f2a91c0: done\nThe history does not hold all of this yet: the "
            "disk is full\n");
}

TEST(PushWords, APushThatItsRobotsConfirmedLaterHasNotFailed) {
  EXPECT_EQ(report_of_push(json{{"state", "told_later"}}).stage, Stage::kDone);
  const auto interrupted = report_of_push(json{{"state", "interrupted"}});
  EXPECT_EQ(interrupted.stage, Stage::kFailed);
  EXPECT_NE(text_of(interrupted).find("Its monitor ended before it did"), std::string::npos);
  const json list{{"pushes", json::array({json{{"state", "told_later"}}})}};
  EXPECT_FALSE(past_pushes(list)[0].has_failed);
}

TEST(PushWords, ARefusalTellsWhy) {
  const auto report = report_of_refusal(json{{"detail", "locked"}}, "somebody else pushes");
  EXPECT_EQ(text_of(report), "Nothing was pushed\nsomebody else pushes\n");
}

TEST(PushWords, PastPushesAreToldAsTheMonitorListsThem) {
  const auto pushes =
      past_pushes(json{{"pushes",
                        {{{"pushed_ns", 12},
                          {"author", "Anna"},
                          {"program", "office.bhdl"},
                          {"hash", "3f2a91c0"},
                          {"state", "failed"},
                          {"targets", {"io"}},
                          {"replies", {{{"robot", "io"}, {"status", "rolled_back"}}}}},
                         {{"state", "done"}}}}});
  ASSERT_EQ(pushes.size(), 2u);
  EXPECT_EQ(pushes[0].pushed_ns, 12);
  EXPECT_EQ(pushes[0].author, "Anna");
  EXPECT_EQ(pushes[0].targets, std::vector<std::string>{"io"});
  EXPECT_EQ(pushes[0].outcomes, std::vector<std::string>{"io rolled_back"});
  EXPECT_TRUE(pushes[0].has_failed);
  EXPECT_FALSE(pushes[1].has_failed);
  EXPECT_TRUE(past_pushes(json::object()).empty());
}

}  // namespace
}  // namespace galilean::monitor::top
