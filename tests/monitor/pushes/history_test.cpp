// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/history/history.h"

#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <set>

#include "core/random.h"
#include "core/wire/messages.h"
#include "core/wire/ros_time.h"
#include "monitor/pushes/history/history_folder.h"
#include "monitor/pushes/history/push_messages.h"
#include "monitor/pushes/history/sql.h"
#include "tests/temporary_folder.h"

namespace galilean::monitor {
namespace {

namespace fs = std::filesystem;

msg::ProgramPush push(int number) {
  msg::ProgramPush result;
  result.id = std::to_string(number);
  result.stamp = wire::ros_time(1'000'000'000LL * number);
  result.author = "operator";
  result.targets = {"io", "ganymede"};
  result.files = {{"main.bhdl", "text " + std::to_string(number % 3)}, {"parts.bhdl", "parts"}};
  result.hash = hash_of_files(result);
  return result;
}

class HistoryTest : public testing::Test {
 protected:
  const TemporaryFolder folder;
  const fs::path file = folder / "new" / "history.sqlite";
};

TEST_F(HistoryTest, IsForItsOwnerAloneAlsoWhereAnEarlierReleaseLetOthersRead) {
  const auto others_rights = [](const fs::path& path) {
    return fs::status(path).permissions() & (fs::perms::group_all | fs::perms::others_all);
  };
  const auto is_private = [&] {
    for (const auto& each : fs::directory_iterator(file.parent_path()))
      if (others_rights(each.path()) != fs::perms::none) return false;
    return others_rights(file.parent_path()) == fs::perms::none;
  };
  {
    const auto history = History::open(file);
    ASSERT_TRUE(history);
    ASSERT_TRUE(history.value()->add(push(1)));
    EXPECT_TRUE(is_private());
  }
  fs::permissions(file, fs::perms::group_read | fs::perms::others_read, fs::perm_options::add);
  ASSERT_TRUE(History::open(file));
  EXPECT_TRUE(is_private());
}

TEST_F(HistoryTest, RemembersWhoPushedWhatToWhomAndWhatBecameOfIt) {
  {
    auto history = History::open(file);
    ASSERT_TRUE(history);
    EXPECT_TRUE(history.value()->add(push(1)));
    EXPECT_TRUE(history.value()->add(push(2)));
    RobotReply reply{.robot = "io", .status = ReplyStatus::kRunning, .latency_ms = 12.5};
    EXPECT_TRUE(history.value()->add_reply("2", reply));
    reply.status = ReplyStatus::kRolledBack;
    reply.reply.message = "overran its ticks";
    EXPECT_TRUE(history.value()->add_reply("2", reply));
  }
  auto history = History::open(file);
  ASSERT_TRUE(history);
  const auto found = history.value()->pushes(10);
  ASSERT_TRUE(found);
  const auto& records = found.value();
  ASSERT_EQ(records.size(), 2U);
  EXPECT_EQ(records[0].id, "2");
  EXPECT_EQ(records[0].program, "main.bhdl");
  EXPECT_EQ(records[0].targets, (std::vector<std::string>{"io", "ganymede"}));
  ASSERT_EQ(records[0].replies.size(), 1U);
  EXPECT_EQ(records[0].replies[0].status, ReplyStatus::kRolledBack);
  EXPECT_EQ(records[0].replies[0].reply.message, "overran its ticks");
  EXPECT_EQ(records[0].replies[0].latency_ms, 12.5);
  EXPECT_EQ(history.value()->program(push(2).hash).value()->at(0).text, "text 2");
  EXPECT_FALSE(history.value()->program("9999").value());
}

/// Adds pushes, their outcome and their end, and tells each number once all has returned.
[[noreturn]] void push_for_ever(const fs::path& file, int first, int channel) {
  auto history = History::open(file);
  for (int number = first; history; ++number) {
    const auto id = std::to_string(number);
    if (!history.value()->add(push(number))) _exit(1);
    if (!history.value()->add_reply(id, {.robot = "io", .status = ReplyStatus::kRunning})) _exit(1);
    const Progress done{.state = PushState::kDone, .trial = nlohmann::json::object()};
    if (!history.value()->set_progress(id, done)) _exit(1);
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
      const auto found = history.value()->push(std::to_string(number));
      ASSERT_TRUE(found);
      const auto& record = found.value();
      ASSERT_TRUE(record) << number;
      EXPECT_EQ(record->progress.state, PushState::kDone);
      EXPECT_EQ(record->replies.size(), 1U);
      EXPECT_TRUE(history.value()->program(record->hash).value());
    }
  }
}

TEST_F(HistoryTest, TheNewestPushIsTheOneThatCameLastWhateverItsSendersClockSays) {
  auto an_hour_ahead = push(1), later = push(4);  // Both are of one program.
  an_hour_ahead.stamp.sec += 3600;
  {
    auto history = History::open(file);
    ASSERT_TRUE(history);
    ASSERT_TRUE(history.value()->add(an_hour_ahead));
    ASSERT_TRUE(history.value()->add(later));
    EXPECT_EQ(history.value()->last_push_of(later.hash).value()->id, "4");
  }
  auto history = History::open(file);
  ASSERT_TRUE(history);
  const auto found = history.value()->pushes(10);
  ASSERT_TRUE(found);
  ASSERT_EQ(found.value().size(), 2U);
  EXPECT_EQ(found.value()[0].id, "4");
  EXPECT_EQ(history.value()->last_push_of(later.hash).value()->id, "4");
}

TEST_F(HistoryTest, PushesOfAReleaseThatDidNotNumberThemKeepTheirOrder) {
  {
    auto history = History::open(file);
    ASSERT_TRUE(history);
    for (const int number : {2, 1, 3}) ASSERT_TRUE(history.value()->add(push(number)));
  }
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(file.c_str(), &database), SQLITE_OK);
  sql::execute(database, "DELETE FROM push_sequence; DELETE FROM chain;");
  sql::execute(database, "DELETE FROM sqlite_sequence");
  sqlite3_close(database);
  auto history = History::open(file);
  ASSERT_TRUE(history);
  ASSERT_TRUE(history.value()->add(push(0)));
  std::string ids;
  const auto kept = history.value()->pushes(10).value();
  for (const auto& record : kept) ids += record.id;
  EXPECT_EQ(ids, "0321");
  EXPECT_FALSE(history.value()->verify().value().broken);
}

TEST_F(HistoryTest, RemembersHowFarAPushCameAndThatItWasInterrupted) {
  {
    auto history = History::open(file);
    Progress progress{.state = PushState::kRunning,
                      .steps = {{StepKind::kCheck, StepState::kDone}}};
    EXPECT_TRUE(history.value()->add(push(1), progress));
    EXPECT_TRUE(history.value()->add(push(2), progress));
    progress = {.state = PushState::kCancelled,
                .steps = {{StepKind::kCheck, StepState::kDone},
                          {StepKind::kCanary, StepState::kCancelled, "cancelled by balch"}},
                .trial = {{"runs", 8}}};
    EXPECT_TRUE(history.value()->set_progress("2", progress));
  }
  auto history = History::open(file);
  EXPECT_EQ(history.value()->push("1").value()->progress.state, PushState::kInterrupted)
      << "its monitor ended";
  const auto cancelled = history.value()->push("2").value();
  EXPECT_EQ(cancelled->progress.state, PushState::kCancelled);
  EXPECT_EQ(cancelled->progress.steps[1].kind, StepKind::kCanary);
  EXPECT_EQ(cancelled->progress.steps[1].state, StepState::kCancelled);
  EXPECT_EQ(cancelled->progress.steps[1].detail, "cancelled by balch");
  EXPECT_EQ(cancelled->progress.trial, (nlohmann::json{{"runs", 8}}));
  EXPECT_EQ(history.value()->last_push_of(push(2).hash).value()->id, "2");
  EXPECT_FALSE(history.value()->push("3").value());
}

std::vector<std::string> row_of(const fs::path& file, const char* question, int columns) {
  sqlite3* database = nullptr;
  sqlite3_open(file.c_str(), &database);
  std::vector<std::string> row;
  {
    sql::Statement found(database, question);
    if (found.step())
      for (int column = 0; column < columns; ++column) row.push_back(found.text(column));
  }
  sqlite3_close(database);
  return row;
}

TEST_F(HistoryTest, TheWordsInTheFileNeverChange) {
  {
    auto history = History::open(file);
    EXPECT_TRUE(
        history.value()->add(push(1), {.steps = {{StepKind::kCheck, StepState::kRunning}}}));
    EXPECT_TRUE(history.value()->set_progress(
        "1",
        {.state = PushState::kDone,
         .steps = {{StepKind::kTry, StepState::kLeftOut}, {StepKind::kRest, StepState::kDone, "x"}},
         .trial = {{"runs", 8}}}));
    EXPECT_TRUE(
        history.value()->add_reply("1", {.robot = "io", .status = ReplyStatus::kRolledBack}));
    EXPECT_TRUE(history.value()->add(push(2), {.state = PushState::kForeign}));
  }
  EXPECT_EQ(row_of(file, "SELECT state, steps, trial FROM progress WHERE push_id = '1'", 3),
            (std::vector<std::string>{"done", R"([["try","left_out",""],["rest","done","x"]])",
                                      R"({"runs":8})"}));
  EXPECT_EQ(row_of(file, "SELECT status FROM answer", 1), std::vector<std::string>{"rolled_back"});
  EXPECT_EQ(row_of(file, "SELECT state, steps, trial FROM progress WHERE push_id = '2'", 3),
            (std::vector<std::string>{"", "[]", ""}));
}

TEST_F(HistoryTest, AFileThatBreaksIsAnErrorOfTheCallAndNoException) {
  auto history = History::open(file);
  EXPECT_TRUE(history.value()->add(push(1)));
  sqlite3* other = nullptr;
  sqlite3_open(file.c_str(), &other);
  sql::execute(other, "DROP TABLE answer; DROP TABLE progress;");
  sqlite3_close(other);
  const auto added = history.value()->add(push(2));
  ASSERT_FALSE(added);
  EXPECT_NE(added.error().message.find("the history of pushes: "), std::string::npos);
  EXPECT_FALSE(history.value()->set_progress("1", {}));
  EXPECT_FALSE(history.value()->add_reply("1", {.robot = "io"}));
  EXPECT_FALSE(history.value()->pushes(10));
  EXPECT_FALSE(history.value()->push("1"));
  EXPECT_FALSE(history.value()->last_push_of(push(1).hash));
}

TEST_F(HistoryTest, TheBeginningOfAHashWillDoWhereItIsTheOnlyOne) {
  auto history = History::open(file);
  EXPECT_TRUE(history.value()->add(push(1)));
  EXPECT_TRUE(history.value()->program("").value());
  EXPECT_TRUE(history.value()->program(push(1).hash.substr(0, 32)).value());
  EXPECT_TRUE(history.value()->add(push(2)));
  EXPECT_FALSE(history.value()->program("").value()) << "which of the two?";
  EXPECT_TRUE(history.value()->program(push(2).hash.substr(0, 32)).value());
}

TEST_F(HistoryTest, APushThatAnnouncesAnothersHashDoesNotTakeItsPlace) {
  auto history = History::open(file);
  ASSERT_TRUE(history);
  auto forged = push(2);
  forged.id = "forged";
  forged.hash = push(1).hash;
  EXPECT_TRUE(history.value()->add(forged));
  EXPECT_FALSE(history.value()->program(push(1).hash).value());
  EXPECT_TRUE(history.value()->add(push(1)));
  EXPECT_EQ(history.value()->program(push(1).hash).value()->at(0).text, "text 1");
  EXPECT_EQ(history.value()->push("forged").value()->hash, push(2).hash);
  EXPECT_EQ(history.value()->last_push_of(push(1).hash).value()->id, "1");
}

TEST_F(HistoryTest, ATextUnderAWrongHashIsToldAndNotGiven) {
  auto history = History::open(file);
  EXPECT_TRUE(history.value()->add(push(1)));
  sqlite3* other = nullptr;
  sqlite3_open(file.c_str(), &other);
  sql::execute(other, "UPDATE program_file SET text = 'another' WHERE position = 0;");
  sqlite3_close(other);
  const auto found = history.value()->program(push(1).hash);
  ASSERT_FALSE(found);
  EXPECT_NE(found.error().message.find("is another program's"), std::string::npos);
  EXPECT_TRUE(history.value()->add(push(2)));
  EXPECT_FALSE(history.value()->program("").value()) << "which of the two?";
  EXPECT_TRUE(history.value()->program(push(2).hash.substr(0, 12)).value());
}

TEST_F(HistoryTest, ATextIsKeptUnderItsOwnHashWhateverAPushAnnounces) {
  auto history = History::open(file);
  EXPECT_TRUE(history.value()->add(push(1)));
  auto forged = push(2);
  forged.hash = push(1).hash;
  forged.files.push_back({"more.bhdl", "more"});
  EXPECT_TRUE(history.value()->add(forged));
  const auto files = history.value()->program(push(1).hash).value();
  ASSERT_TRUE(files);
  ASSERT_EQ(files->size(), 2U) << "what was there is as it was";
  EXPECT_EQ(files->at(0).text, "text 1");
  EXPECT_EQ(history.value()->program(hash_of_files(forged)).value()->at(0).text, "text 2");
  EXPECT_EQ(history.value()->push("2").value()->hash, hash_of_files(forged));
  EXPECT_EQ(history.value()->last_push_of(push(1).hash).value()->id, "1");
}

TEST_F(HistoryTest, APushThatComesTwiceIsKeptAsItWas) {
  auto history = History::open(file);
  EXPECT_TRUE(history.value()->add(push(1), {.state = PushState::kDone}));
  auto again = push(1);
  again.author = "another";
  EXPECT_TRUE(history.value()->add(again, {.state = PushState::kForeign}));
  EXPECT_EQ(history.value()->push("1").value()->author, "operator");
  EXPECT_EQ(history.value()->push("1").value()->progress.state, PushState::kDone);
}

TEST_F(HistoryTest, RemembersOrdersWithWhatBecameOfThem) {
  auto history = History::open(file, {.now_ns = [] { return std::int64_t{9}; }});
  const OrderRecord hold{.id = "a",
                         .ordered_ns = 5,
                         .author = "balch",
                         .kind = "hold",
                         .targets = {"io"},
                         .detail = {},
                         .outcomes = {}};
  EXPECT_TRUE(history.value()->add_order(hold));
  EXPECT_TRUE(history.value()->add_order(hold)) << "it comes twice, and is kept once";
  auto second = hold;
  second.id = "b";
  second.kind = "resume";
  EXPECT_TRUE(history.value()->add_order(second));
  EXPECT_TRUE(history.value()->add_outcome("a", {.of = "io", .outcome = "is held"}));
  const auto orders = history.value()->orders(10).value();
  ASSERT_EQ(orders.size(), 2U);
  EXPECT_EQ(orders[0].kind, "resume") << "the newest first";
  EXPECT_EQ(orders[1].author, "balch");
  EXPECT_EQ(orders[1].ordered_ns, 5);
  EXPECT_EQ(orders[1].targets, std::vector<std::string>{"io"});
  ASSERT_EQ(orders[1].outcomes.size(), 1U);
  EXPECT_EQ(orders[1].outcomes[0].outcome, "is held");
  EXPECT_EQ(orders[1].outcomes[0].told_ns, 9);
  EXPECT_EQ(history.value()->orders(1).value().size(), 1U);
  EXPECT_FALSE(history.value()->verify().value().broken);
}

TEST_F(HistoryTest, APushThatWasRefusedIsKnownToTheNextMonitor) {
  const RefusedPush refused{.id = "order-0001",
                            .ordered_ns = 5,
                            .author = "balch",
                            .targets = {"io"},
                            .program = "main.bhdl",
                            .reason = "conflict",
                            .message = "io runs another program."};
  {
    auto history = History::open(file);
    EXPECT_TRUE(history.value()->add_refused_push(refused));
    auto again = refused;
    again.message = "It is another one.";
    EXPECT_TRUE(history.value()->add_refused_push(again)) << "it comes twice, and is kept once";
    EXPECT_TRUE(history.value()->add(push(1)));
  }
  auto history = History::open(file);
  const auto found = history.value()->refused_push("order-0001").value();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->author, "balch");
  EXPECT_EQ(found->targets, std::vector<std::string>{"io"});
  EXPECT_EQ(found->reason, "conflict");
  EXPECT_EQ(found->message, "io runs another program.");
  EXPECT_FALSE(history.value()->refused_push("1").value()) << "it was not refused";
  EXPECT_FALSE(history.value()->push("order-0001").value()) << "it is no push";
  const auto orders = history.value()->orders(10).value();
  ASSERT_EQ(orders.size(), 1U);
  EXPECT_EQ(orders[0].kind, "push");
  ASSERT_EQ(orders[0].outcomes.size(), 1U);
  EXPECT_EQ(orders[0].outcomes[0].outcome, "refused: io runs another program.");
  EXPECT_FALSE(history.value()->verify().value().broken);
}

TEST_F(HistoryTest, APushOfOthersThatNoRobotTookDoesNotCountAsTheOneThatBroughtAProgram) {
  auto history = History::open(file);
  EXPECT_TRUE(history.value()->add(push(1), {.state = PushState::kDone}));
  auto strangers = push(4);  // of the same program
  strangers.author = "mallory";
  EXPECT_TRUE(history.value()->add(strangers, {.state = PushState::kForeign}));
  EXPECT_TRUE(history.value()->add_reply("4", {.robot = "io", .status = ReplyStatus::kRejected}));
  EXPECT_EQ(history.value()->last_push_of(push(1).hash).value()->author, "operator");
  EXPECT_TRUE(history.value()->add_reply("4", {.robot = "io", .status = ReplyStatus::kRunning}));
  EXPECT_EQ(history.value()->last_push_of(push(1).hash).value()->author, "mallory");
}

TEST_F(HistoryTest, AFolderThatCannotBeWrittenIsAnErrorThatSaysWhatToDo) {
  std::ofstream(folder / "file") << "no folder";
  const auto history = History::open(folder / "file" / "history.sqlite");
  ASSERT_FALSE(history);
  EXPECT_NE(history.error().message.find("--data DIR"), std::string::npos);
}

TEST(HistoryFolder, IsOneForEachDomainAndPort) {
  const fs::path data = "/data";
  std::set<fs::path> folders;
  for (const std::uint32_t domain : {0U, 7U, 80U})
    for (const std::uint16_t port : {std::uint16_t{80}, std::uint16_t{8080}, std::uint16_t{8090}})
      folders.insert(history_folder(data, domain, port));
  EXPECT_EQ(folders.size(), 9U);
  EXPECT_EQ(history_folder(data, 0, 8080), data) << "where it always was";
  EXPECT_EQ(history_folder(data, 7, 8090), data / "histories" / "domain-7-port-8090");
}

TEST(HistoryFolder, IsNotSharedByMonitorsThatTakeAnyFreePortAtTheSameTime) {
  const TemporaryFolder data;
  const auto first = history_file(data.path(), 7, 0);
  EXPECT_EQ(first, data / "histories" / "domain-7-port-0" / "history.sqlite");
  {
    const auto history = History::open(first);
    ASSERT_TRUE(history) << history.error().message;
    const auto second = history_file(data.path(), 7, 0);
    EXPECT_EQ(second, data / "histories" / "domain-7-port-0-2" / "history.sqlite");
    ASSERT_TRUE(History::open(second));
  }
  EXPECT_EQ(history_file(data.path(), 7, 0), first) << "nobody uses it any more";
}

}  // namespace
}  // namespace galilean::monitor
