// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/history.h"

#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "core/random.h"
#include "core/wire/messages.h"
#include "core/wire/ros_time.h"
#include "monitor/pushes/sql.h"
#include "tests/temporary_folder.h"

namespace galilean::monitor {
namespace {

namespace fs = std::filesystem;

msg::ProgramPush push(int number) {
  msg::ProgramPush result;
  result.id = std::to_string(number);
  result.stamp = wire::ros_time(1'000'000'000LL * number);
  result.author = "operator";
  result.hash = "hash" + std::to_string(number % 3);
  result.targets = {"io", "ganymede"};
  result.files = {{"main.bhdl", "text " + std::to_string(number % 3)}, {"parts.bhdl", "parts"}};
  return result;
}

class HistoryTest : public testing::Test {
 protected:
  const TemporaryFolder folder;
  const fs::path file = folder / "new" / "history.sqlite";
};

TEST_F(HistoryTest, RemembersWhoPushedWhatToWhomAndWhatBecameOfIt) {
  {
    auto history = History::open(file);
    ASSERT_TRUE(history);
    history.value()->add(push(1));
    history.value()->add(push(2));
    PushAnswer answer{.robot = "io", .status = "running", .latency_ms = 12.5};
    history.value()->add_answer("2", answer);
    answer.status = "rolled_back";
    answer.reply.message = "overran its ticks";
    history.value()->add_answer("2", answer);
  }
  auto history = History::open(file);
  ASSERT_TRUE(history);
  const auto records = history.value()->pushes(10);
  ASSERT_EQ(records.size(), 2U);
  EXPECT_EQ(records[0].id, "2");
  EXPECT_EQ(records[0].program, "main.bhdl");
  EXPECT_EQ(records[0].targets, (std::vector<std::string>{"io", "ganymede"}));
  ASSERT_EQ(records[0].answers.size(), 1U);
  EXPECT_EQ(records[0].answers[0].status, "rolled_back");
  EXPECT_EQ(records[0].answers[0].reply.message, "overran its ticks");
  EXPECT_EQ(history.value()->program("hash2")->at(0).text, "text 2");
  EXPECT_FALSE(history.value()->program("hash9"));
}

/// Adds pushes, their outcome and their end, and tells each number once all has returned.
[[noreturn]] void push_for_ever(const fs::path& file, int first, int channel) {
  auto history = History::open(file);
  for (int number = first; history; ++number) {
    const auto id = std::to_string(number);
    history.value()->add(push(number));
    history.value()->add_answer(id, {.robot = "io", .status = "running"});
    history.value()->set_progress(id, {.state = "done", .trial_json = "{}"});
    if (::write(channel, &number, sizeof number) < 0) _exit(1);
  }
  _exit(1);
}

/// Kills a writer some time after its first word; the last number that it told.
int last_told_before_kill(const fs::path& file, int first, std::chrono::microseconds after) {
  int channel[2];
  if (pipe(channel) != 0) return -1;
  const pid_t writer = fork();
  if (writer == 0) push_for_ever(file, first, channel[1]);
  close(channel[1]);
  int told = -1;
  if (::read(channel[0], &told, sizeof told) == sizeof told)
    usleep(static_cast<unsigned>(after.count()));
  kill(writer, SIGKILL);
  waitpid(writer, nullptr, 0);
  for (int later = 0; ::read(channel[0], &later, sizeof later) == sizeof later;) told = later;
  close(channel[0]);
  return told;
}

std::string integrity(const fs::path& file) {
  sqlite3* database = nullptr;
  sqlite3_open(file.c_str(), &database);
  std::string found;
  {
    sql::Statement check(database, "PRAGMA integrity_check");
    if (check.step()) found = check.text(0);
  }
  sqlite3_close(database);
  return found;
}

TEST_F(HistoryTest, WhatItReturnedFromSurvivesKill9AtAnyInstant) {
  constexpr int kKills = 25;
  Random random(1);
  int told = 0;
  for (int kill = 0; kill < kKills; ++kill) {
    const auto after = std::chrono::microseconds(static_cast<int>(random.uniform(0, 20'000)));
    // What was under way when it was killed may be there or not; its number is not used again.
    const int first = told + 2;
    told = last_told_before_kill(file, first, after);
    ASSERT_GE(told, first);
    ASSERT_EQ(integrity(file), "ok");
    auto history = History::open(file);
    ASSERT_TRUE(history);
    for (int number = first; number <= told; ++number) {
      const auto record = history.value()->push(std::to_string(number));
      ASSERT_TRUE(record) << number;
      EXPECT_EQ(record->progress.state, "done");
      EXPECT_EQ(record->answers.size(), 1U);
      EXPECT_TRUE(history.value()->program(record->hash));
    }
  }
}

TEST_F(HistoryTest, RemembersHowFarAPushCameAndThatItWasInterrupted) {
  {
    auto history = History::open(file);
    SwapProgress progress{.state = "running", .steps = {{"check", "done", ""}}, .trial_json = ""};
    history.value()->add(push(1), progress);
    history.value()->add(push(2), progress);
    progress = {.state = "cancelled",
                .steps = {{"check", "done", ""}, {"canary", "cancelled", "cancelled by balch"}},
                .trial_json = R"({"runs":8})"};
    history.value()->set_progress("2", progress);
  }
  auto history = History::open(file);
  EXPECT_EQ(history.value()->push("1")->progress.state, "interrupted") << "its monitor ended";
  const auto cancelled = history.value()->push("2");
  EXPECT_EQ(cancelled->progress.state, "cancelled");
  EXPECT_EQ(cancelled->progress.steps[1].detail, "cancelled by balch");
  EXPECT_EQ(cancelled->progress.trial_json, R"({"runs":8})");
  EXPECT_EQ(history.value()->last_push_of("hash2")->id, "2");
  EXPECT_FALSE(history.value()->push("3"));
}

TEST_F(HistoryTest, TheBeginningOfAHashWillDoWhereItIsTheOnlyOne) {
  auto history = History::open(file);
  history.value()->add(push(1));
  EXPECT_TRUE(history.value()->program("ha"));
  history.value()->add(push(2));
  EXPECT_FALSE(history.value()->program("ha")) << "hash1 or hash2?";
  EXPECT_TRUE(history.value()->program("hash2"));
}

TEST_F(HistoryTest, AFolderThatCannotBeWrittenIsAnErrorThatSaysWhatToDo) {
  std::ofstream(folder / "file") << "no folder";
  const auto history = History::open(folder / "file" / "history.sqlite");
  ASSERT_FALSE(history);
  EXPECT_NE(history.error().message.find("--data DIR"), std::string::npos);
}

}  // namespace
}  // namespace galilean::monitor
