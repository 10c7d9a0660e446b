// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/front/process.h"

#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

#include "tests/temporary_folder.h"

namespace galilean::front {
namespace {

namespace fs = std::filesystem;

class Processes : public testing::Test {
 protected:
  void SetUp() override { ASSERT_EQ(mkfifo(word.c_str(), 0600), 0); }
  Process shell(const std::string& script) {
    auto process = Process::start("sh", {"/bin/sh", "-c", script}, log);
    if (!process) throw std::runtime_error(process.error().message);
    return std::move(process).value();
  }
  /// What a script says with `echo … >word`; waits for it.
  std::string said() {
    std::string line;
    std::getline(std::ifstream(word) >> std::ws, line);
    return line;
  }

  TemporaryFolder folder;
  fs::path log = folder / "sh.log";
  fs::path word = folder / "word";
};

bool exists(pid_t pid) {
  return kill(pid, 0) == 0;
}

/// Readable once that process has ended, whoever reaps it.
bool ends_within(int process_descriptor, int timeout_ms) {
  pollfd process{process_descriptor, POLLIN, 0};
  return poll(&process, 1, timeout_ms) == 1;
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

TEST_F(Processes, LogForTheirOwnerAlone) {
  std::ofstream(log) << "an earlier run\n";
  fs::permissions(log, fs::perms::others_read, fs::perm_options::add);
  auto process = shell("echo a token");
  EXPECT_TRUE(process.end());
  EXPECT_EQ(fs::status(log).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(Processes, AreAskedToEndBeforeTheyAreMade) {
  Process process = shell("trap 'echo bye; exit 0' TERM; echo up >" + word.string() +
                          "; while :; do read line <" + word.string() + "; done");
  EXPECT_EQ(said(), "up");
  process.ask_to_end();
  EXPECT_TRUE(process.end());
  EXPECT_EQ(last_lines(log, 1), "    bye\n");
}

TEST_F(Processes, EndWithTheirObject) {
  pid_t pid = 0;
  {
    const Process process = shell("echo up >" + word.string() + "; exec cat " + word.string());
    pid = process.pid();
    EXPECT_EQ(said(), "up");
  }
  EXPECT_FALSE(exists(pid));
}

TEST_F(Processes, EndWhenWhoStartedThemIsKilled) {
  const pid_t parent = fork();
  if (parent == 0) {
    const Process process = shell("echo $$ >" + word.string() + "; exec cat " + word.string());
    pause();
    _exit(0);
  }
  const pid_t orphan = std::stoi(said());
  const int descriptor = static_cast<int>(syscall(SYS_pidfd_open, orphan, 0));
  ASSERT_GE(descriptor, 0);
  EXPECT_FALSE(ends_within(descriptor, 0));
  kill(parent, SIGKILL);
  waitpid(parent, nullptr, 0);
  EXPECT_TRUE(ends_within(descriptor, 5000));
  close(descriptor);
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
