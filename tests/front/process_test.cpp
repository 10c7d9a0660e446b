#include "front/process.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <thread>

namespace galilean::front {
namespace {

namespace fs = std::filesystem;

class Processes : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder); }
  void TearDown() override { fs::remove_all(folder); }
  Process shell(const std::string& script) {
    auto process = Process::start("sh", {"/bin/sh", "-c", script}, log);
    if (!process) throw std::runtime_error(process.error().message);
    return std::move(process).value();
  }
  /// The log's first line, once it is there.
  std::string first_line() {
    for (int i = 0; i < 5000; ++i) {
      if (const auto line = line_with(log, "")) return *line;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return {};
  }

  fs::path folder = fs::path(testing::TempDir()) / ("process_test_" + std::to_string(getpid()));
  fs::path log = folder / "sh.log";
};

bool exists(pid_t pid) {
  return kill(pid, 0) == 0;
}

TEST_F(Processes, SayHowTheyEnded) {
  Process well = shell("exit 0"), badly = shell("exit 3"), killed = shell("kill -9 $$");
  for (Process* process : {&well, &badly, &killed}) EXPECT_TRUE(process->end());
  EXPECT_TRUE(well.ended_well());
  EXPECT_EQ(badly.ending(), "exit code 3");
  EXPECT_EQ(killed.ending(), "killed by signal 9 (Killed)");
  EXPECT_FALSE(killed.ended_well());
}

TEST_F(Processes, LogWhatTheyPrint) {
  Process process = shell("echo one; echo two >&2; echo three");
  EXPECT_TRUE(process.end());
  EXPECT_EQ(last_lines(log, 2), "    two\n    three\n");
  EXPECT_EQ(line_with(log, "tw"), "two");
  EXPECT_FALSE(line_with(log, "four"));
}

TEST_F(Processes, AreAskedToEndBeforeTheyAreMade) {
  Process process = shell("trap 'echo bye; exit 0' TERM; echo up; while :; do sleep 0.01; done");
  EXPECT_EQ(first_line(), "up");
  process.ask_to_end();
  EXPECT_TRUE(process.end());
  EXPECT_EQ(last_lines(log, 1), "    bye\n");
}

TEST_F(Processes, EndWithTheirObject) {
  pid_t pid = 0;
  {
    const Process process = shell("echo up; exec sleep 100");
    pid = process.pid();
    EXPECT_EQ(first_line(), "up");
  }
  EXPECT_FALSE(exists(pid));
}

TEST_F(Processes, EndWhenWhoStartedThemIsKilled) {
  const pid_t parent = fork();
  if (parent == 0) {
    const Process process = shell("echo $$; exec sleep 100");
    pause();
    _exit(0);
  }
  const pid_t orphan = std::stoi(first_line());
  EXPECT_TRUE(exists(orphan));
  kill(parent, SIGKILL);
  waitpid(parent, nullptr, 0);
  // Whoever inherits it reaps it; until then its number stays, as a zombie's.
  const auto ended = [&] {
    std::ifstream status("/proc/" + std::to_string(orphan) + "/stat");
    std::string number, name, state;
    return !(status >> number >> name >> state) || state == "Z";
  };
  for (int i = 0; i < 5000 && !ended(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_TRUE(ended());
}

TEST_F(Processes, ThatCannotBeStartedSayWhy) {
  auto process = Process::start("ghost", {"/nonexistent/ghost"}, log);
  ASSERT_TRUE(process.ok());
  EXPECT_TRUE(process.value().end());
  EXPECT_EQ(process.value().ending(), "exit code 127");
  EXPECT_EQ(last_lines(log, 1), "    No such file or directory\n");
}

}  // namespace
}  // namespace galilean::front
