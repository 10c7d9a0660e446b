// SPDX-License-Identifier: BSD-3-Clause
// Whatever is changed in a history's file is found, and its row named.
#include <gmock/gmock.h>
#include <sqlite3.h>

#include <fstream>

#include "core/random.h"
#include "core/wire/ros_time.h"
#include "monitor/pushes/history/history.h"
#include "monitor/pushes/history/push_messages.h"
#include "monitor/pushes/history/sql.h"
#include "tests/temporary_folder.h"

namespace galilean::monitor {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr std::int64_t kFirst_ns = 1'700'000'000'000'000'000;

msg::ProgramPush chained_push(int number) {
  msg::ProgramPush push;
  push.id = std::to_string(number);
  push.stamp = wire::ros_time(kFirst_ns + number);
  push.author = "balch";
  push.targets = {"io"};
  push.files = {{"main.bhdl", "text " + std::to_string(number)}};
  push.hash = hash_of_files(push);
  return push;
}

/// Changes the file as somebody with an editor of databases would.
void tamper(const fs::path& file, const std::string& text) {
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(file.c_str(), &database), SQLITE_OK);
  sql::execute(database, text.c_str());
  EXPECT_GT(sqlite3_changes(database), 0) << text << " changed nothing";
  sqlite3_close(database);
}

class HistoryChainTest : public testing::Test {
 protected:
  /// Three pushes of three rows each: the push, its progress, a reply; then an order of one row.
  void SetUp() override {
    std::int64_t now_ns = kFirst_ns;
    auto history = History::open(file, {.now_ns = [&] { return now_ns += 1'000'000'000; }});
    ASSERT_TRUE(history);
    for (int number = 1; number <= 3; ++number) {
      ASSERT_TRUE(history.value()->add(chained_push(number), {.state = PushState::kDone}));
      ASSERT_TRUE(history.value()->add_reply(std::to_string(number),
                                             {.robot = "io", .status = ReplyStatus::kConfirmed}));
    }
    ASSERT_TRUE(history.value()->add_order({.id = "hold",
                                            .ordered_ns = 5,
                                            .author = "collins",
                                            .kind = "hold",
                                            .targets = {},
                                            .detail = {},
                                            .outcomes = {}}));
  }

  [[nodiscard]] Verification verified() const {
    const auto found = verify_history(file);
    EXPECT_TRUE(found) << found.error().message;
    return found ? found.value() : Verification();
  }
  [[nodiscard]] BrokenRow broken() const {
    const auto found = verified();
    EXPECT_TRUE(found.broken) << "nothing was found";
    return found.broken.value_or(BrokenRow());
  }

  const TemporaryFolder folder;
  const fs::path file = folder / "history.sqlite";
};

TEST_F(HistoryChainTest, IsWholeAsItWasWritten) {
  const auto found = verified();
  EXPECT_FALSE(found.broken);
  EXPECT_EQ(found.rows, 10);
  EXPECT_EQ(found.head.size(), 64U);
  EXPECT_THAT(in_words(found), HasSubstr("The history is whole: 10 rows"));
}

TEST_F(HistoryChainTest, FindsAnAuthorThatWasChangedInTheListOfPushes) {
  tamper(file, "UPDATE push SET author = 'mallory' WHERE id = '2'");
  const auto row = broken();
  EXPECT_EQ(row.number, 4);
  EXPECT_THAT(row.what,
              HasSubstr(R"(author of push 2 differs: the row tells "balch", the list "mallory")"));
}

TEST_F(HistoryChainTest, FindsAnAuthorThatWasChangedInTheChain) {
  tamper(file, "UPDATE chain SET content = replace(content, 'balch', 'mallory') WHERE number = 4");
  const auto row = broken();
  EXPECT_EQ(row.number, 4);
  EXPECT_THAT(row.what, HasSubstr("its content was changed"));
  EXPECT_THAT(row.what, HasSubstr("author of push 2 differs"));
}

TEST_F(HistoryChainTest, FindsAnAuthorThatWasChangedInBoth) {
  tamper(file, "UPDATE push SET author = 'mallory' WHERE id = '2'");
  tamper(file, "UPDATE chain SET content = replace(content, 'balch', 'mallory') WHERE number = 4");
  EXPECT_EQ(broken().number, 4);
}

TEST_F(HistoryChainTest, FindsThatPushesChangedPlaces) {
  tamper(file, "UPDATE push_sequence SET sequence = 9 WHERE push_id = '2'");
  EXPECT_EQ(broken().number, 4);
  EXPECT_THAT(broken().what, HasSubstr("sequence of push 2 differs"));
}

TEST_F(HistoryChainTest, FindsATimeThatWasChanged) {
  tamper(file, "UPDATE chain SET time_ns = time_ns + 1 WHERE number = 7");
  EXPECT_EQ(broken().number, 7);
  EXPECT_THAT(in_words(verified()), HasSubstr("Row 7 of 20"));
}

TEST_F(HistoryChainTest, FindsATextThatWasChanged) {
  tamper(file, "UPDATE program_file SET text = 'worse' WHERE text = 'text 3'");
  const auto row = broken();
  EXPECT_EQ(row.number, 7);
  EXPECT_THAT(row.what, HasSubstr("was changed: it does not have this hash"));
  const auto history = History::open(file);
  const auto program = history.value()->program(chained_push(3).hash);
  ASSERT_FALSE(program) << "nobody restores it";
  EXPECT_THAT(program.error().message, HasSubstr("galilean programs verify"));
}

TEST_F(HistoryChainTest, FindsRowsThatWereTakenAway) {
  tamper(file, "DELETE FROM chain WHERE number = 5");
  EXPECT_EQ(broken().number, 5);
  EXPECT_THAT(broken().what, HasSubstr("it is missing"));
}

TEST_F(HistoryChainTest, FindsThatTheLastRowsWereTakenAway) {
  tamper(file, "DELETE FROM chain WHERE number >= 10");
  EXPECT_EQ(broken().number, 10);
}

TEST_F(HistoryChainTest, FindsThatRowsChangedPlaces) {
  const auto copy = folder / "copy";
  fs::copy_file(file, copy);
  // Rows 4 and 7, with all that they hold.
  tamper(file, "UPDATE chain SET number = -1 WHERE number = 4");
  tamper(file, "UPDATE chain SET number = 4 WHERE number = 7");
  tamper(file, "UPDATE chain SET number = 7 WHERE number = -1");
  EXPECT_EQ(broken().number, 4);
  EXPECT_THAT(broken().what, HasSubstr("does not follow the row that stands before it now"));
  // What they tell, each under the number of the other.
  tamper(
      copy,
      "UPDATE chain SET content = (SELECT other.content FROM chain AS other WHERE other.number = "
      "11 - chain.number) WHERE number IN (4, 7)");
  const auto found = verify_history(copy);
  ASSERT_TRUE(found && found.value().broken);
  EXPECT_EQ(found.value().broken->number, 4);
}

TEST_F(HistoryChainTest, FindsThatTheEndIsMissingByTheHashThatWasNoted) {
  const auto noted = verified().head;
  EXPECT_FALSE(verify_history(file, noted).value().broken);
  {
    auto history = History::open(file);
    ASSERT_TRUE(history.value()->add(chained_push(4)));
  }
  EXPECT_FALSE(verify_history(file, noted).value().broken) << "more rows may follow it";
  EXPECT_FALSE(verify_history(file, noted.substr(0, 12)).value().broken) << "its beginning will do";
  // Whoever takes rows away, and every trace of them.
  tamper(file, "DELETE FROM push WHERE id = '4'");
  tamper(file, "DELETE FROM push_sequence WHERE push_id = '4'");
  tamper(file, "DELETE FROM progress WHERE push_id = '4'");
  tamper(file, "DELETE FROM chain WHERE number >= 10");
  tamper(file, "UPDATE sqlite_sequence SET seq = 9 WHERE name = 'chain'");
  EXPECT_FALSE(verified().broken) << "the file alone does not tell it";
  const auto found = verify_history(file, noted);
  ASSERT_TRUE(found && found.value().broken);
  EXPECT_THAT(in_words(found.value()), HasSubstr(noted));
  EXPECT_THAT(found.value().broken->what, HasSubstr("was taken away, or the chain was made anew"));
}

TEST_F(HistoryChainTest, FindsWhatWasTakenOutOfTheTables) {
  tamper(file, "DELETE FROM answer WHERE push_id = '1'");
  EXPECT_EQ(broken().number, 3);
  EXPECT_THAT(broken().what, HasSubstr("was taken out of the list"));
}

TEST_F(HistoryChainTest, FindsWhatWasAddedToTheTablesAlone) {
  tamper(file, "INSERT INTO answer VALUES('1', 'ganymede', 'confirmed', '', '', 0)");
  EXPECT_EQ(broken().number, 0);
  EXPECT_THAT(broken().what, HasSubstr("of which no row tells"));
}

TEST_F(HistoryChainTest, IsContinuedAfterItWasBrokenAndStaysBroken) {
  tamper(file, "DELETE FROM chain WHERE number = 10");
  {
    auto history = History::open(file);
    ASSERT_TRUE(history.value()->add(chained_push(4)));
  }
  EXPECT_EQ(broken().number, 10) << "its number is not given again";
}

TEST_F(HistoryChainTest, FindsAnyCellThatIsChanged) {
  Random random(1);
  const std::vector<std::string> columns{
      "time_ns = time_ns + 1",    "kind = kind || 'x'", "subject = subject || 'x'",
      "content = content || ' '", "before = 'x'",       "hash = 'x'"};
  for (int play = 0; play < 60; ++play) {
    const auto copy = folder / ("copy" + std::to_string(play));
    fs::copy_file(file, copy);
    const int number = 1 + static_cast<int>(random.below(10));
    const auto& column = columns[random.below(static_cast<std::uint32_t>(columns.size()))];
    tamper(copy, "UPDATE chain SET " + column + " WHERE number = " + std::to_string(number));
    const auto found = verify_history(copy);
    ASSERT_TRUE(found);
    ASSERT_TRUE(found.value().broken) << column << " of row " << number;
    EXPECT_EQ(found.value().broken->number, number) << column;
  }
}

TEST_F(HistoryChainTest, AHistoryWithoutAChainIsTakenOver) {
  // As older releases left it, with a text under a hash that a refused push had announced.
  tamper(file, "DELETE FROM chain");
  tamper(file, "DELETE FROM sqlite_sequence WHERE name = 'chain'");
  tamper(file,
         "INSERT INTO program_file SELECT hash, 1, 'more.bhdl', 'more' FROM program_file "
         "WHERE text = 'text 1'");
  tamper(file, "INSERT INTO program_file VALUES('announced', 0, 'theirs.bhdl', 'theirs')");
  {
    auto history = History::open(file);
    ASSERT_TRUE(history) << history.error().message;
    ASSERT_EQ(history.value()->pushes(10).value().size(), 3U);
    EXPECT_EQ(history.value()->program(chained_push(1).hash).value()->size(), 1U);
    EXPECT_FALSE(history.value()->program("announced").value());
  }
  const auto found = verified();
  EXPECT_FALSE(found.broken) << in_words(found);
  EXPECT_EQ(found.rows, 1 + 3 * 3) << "a row that says so, and one for each that was there";
  tamper(file, "UPDATE push SET author = 'mallory' WHERE id = '3'");
  EXPECT_EQ(broken().number, 4);
}

TEST_F(HistoryChainTest, AFileThatIsNoHistoryIsAnError) {
  EXPECT_FALSE(verify_history(folder / "nothing"));
  std::ofstream(folder / "letter") << std::string(5000, 'x');
  const auto found = verify_history(folder / "letter");
  ASSERT_FALSE(found);
  EXPECT_THAT(found.error().message, HasSubstr("letter"));
  tamper(file, "DELETE FROM chain");
  EXPECT_TRUE(verified().broken) << "all rows were taken away";
}

}  // namespace
}  // namespace galilean::monitor
