#include "monitor/programs/history.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "core/wire/topics.h"
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

TEST_F(HistoryTest, WhatItReturnedFromSurvivesKill9) {
  int channel[2];
  ASSERT_EQ(pipe(channel), 0);
  const pid_t writer = fork();
  if (writer == 0) {
    auto history = History::open(file);
    for (int number = 1; history; ++number) {
      history.value()->add(push(number));
      if (::write(channel[1], &number, sizeof number) < 0) _exit(1);
    }
    _exit(1);
  }
  close(channel[1]);
  int written = 0;
  while (written < 25) ASSERT_EQ(::read(channel[0], &written, sizeof written), int{sizeof written});
  kill(writer, SIGKILL);
  waitpid(writer, nullptr, 0);
  for (int later = 0; ::read(channel[0], &later, sizeof later) == sizeof later;) written = later;
  close(channel[0]);
  auto history = History::open(file);
  ASSERT_TRUE(history);
  EXPECT_GE(history.value()->pushes(10'000).size(), static_cast<std::size_t>(written));
}

TEST_F(HistoryTest, AFolderThatCannotBeWrittenIsAnErrorThatSaysWhatToDo) {
  std::ofstream(folder / "file") << "no folder";
  const auto history = History::open(folder / "file" / "history.sqlite");
  ASSERT_FALSE(history);
  EXPECT_NE(history.error().message.find("--data DIR"), std::string::npos);
}

}  // namespace
}  // namespace galilean::monitor
