// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "core/wire/messages.h"
#include "core/wire/participant.h"
#include "core/wire/topic_names.h"
#include "core/wire/writer.h"
#include "tests/core/wire/wait_until.h"
#include "tests/free_domain.h"

extern char** environ;

namespace galilean::wire {
namespace {

/// Processes that share one input, which ends when told to, and one output.
class Team {
 public:
  /// Each of them says "met" when it has read the states of `robots` robots.
  Team(int size, int robots) {
    if (pipe(input_.data()) || pipe(output_.data())) throw std::runtime_error("pipe");
    for (int i = 0; i < size; ++i) spawn("robot" + std::to_string(i), robots);
    close(input_[0]);
    close(output_[1]);
  }
  /// What the next of them said; empty when all have ended.
  std::string next_word() {
    std::string word;
    for (char c; read(output_[0], &c, 1) == 1 && c != '\n';) word += c;
    return word;
  }
  void kill() {
    for (const pid_t pid : pids_) ::kill(pid, SIGKILL);
  }
  [[nodiscard]] int domain() const { return domain_; }
  /// How many ended well.
  int dismiss() {
    close(input_[1]);
    int well = 0;
    for (const pid_t pid : pids_) {
      int status = 0;
      waitpid(pid, &status, 0);
      well += WIFEXITED(status) && WEXITSTATUS(status) == 0;
    }
    close(output_[0]);
    return well;
  }

 private:
  void spawn(std::string name, int robots) {
    std::string program = GALILEAN_BINARY_DIR "/tests/wire_neighbour",
                domain = std::to_string(domain_);
    std::string count = std::to_string(robots);
    std::array<char*, 5> arguments{program.data(), name.data(), count.data(), domain.data()};
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, input_[0], STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, output_[1], STDOUT_FILENO);
    for (const int end : {input_[0], input_[1], output_[0], output_[1]})
      posix_spawn_file_actions_addclose(&actions, end);
    pid_t pid = 0;
    if (posix_spawn(&pid, program.c_str(), &actions, nullptr, arguments.data(), environ) == 0)
      pids_.push_back(pid);
    posix_spawn_file_actions_destroy(&actions);
  }

  const int domain_ = free_domain();
  std::array<int, 2> input_{}, output_{};
  std::vector<pid_t> pids_;
};

void expect_all_meet(int size) {
  Team team(size, size);
  int met = 0;
  for (int i = 0; i < size; ++i) met += team.next_word() == "met";
  EXPECT_EQ(met, size);
  EXPECT_EQ(team.dismiss(), size);
}

TEST(WireTeam, TwelveProcessesOnOneMachineMeet) {
  expect_all_meet(12);
}

TEST(WireTeam, TwelveMeetWithoutMulticast) {
  setenv("CYCLONEDDS_URI",
         "<Domain><General><AllowMulticast>false</AllowMulticast></General></Domain>", 1);
  expect_all_meet(12);
  unsetenv("CYCLONEDDS_URI");
}

TEST(WireTeam, WritersWaitTogetherForAReaderThatWasKilled) {
  constexpr int kWriters = 12;
  Team team(1, 1 + kWriters);
  const auto joined = Participant::join("io", team.domain());
  ASSERT_TRUE(joined);
  std::vector<Writer<msg::RobotState>> writers;
  const auto all_write = [&] {
    return std::ranges::all_of(writers, [](auto& writer) { return writer.write({}); });
  };
  for (int i = 0; i < kWriters; ++i)
    writers.emplace_back(*joined.value(), robot_topic("io" + std::to_string(i), "state"));
  ASSERT_TRUE(all_write());
  ASSERT_EQ(team.next_word(), "met");
  team.kill();
  ASSERT_EQ(team.dismiss(), 0);
  ASSERT_TRUE(all_write());
  EXPECT_GT(writers.front().readers(), 0);

  const auto start = std::chrono::steady_clock::now();
  writers.clear();
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(kWriters / 2));
}

}  // namespace
}  // namespace galilean::wire
