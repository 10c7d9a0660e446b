// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>

#include "tests/free_domain.h"

extern char** environ;

namespace galilean::wire {
namespace {

/// Processes that share one input, which ends when told to, and one output.
class Team {
 public:
  explicit Team(int size) {
    if (pipe(input_.data()) || pipe(output_.data())) throw std::runtime_error("pipe");
    for (int i = 0; i < size; ++i) spawn("robot" + std::to_string(i), size);
    close(input_[0]);
    close(output_[1]);
  }
  /// What the next of them said; empty when all have ended.
  std::string next_word() {
    std::string word;
    for (char c; read(output_[0], &c, 1) == 1 && c != '\n';) word += c;
    return word;
  }
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
  void spawn(std::string name, int size) {
    std::string program = GALILEAN_BINARY_DIR "/tests/wire_neighbour",
                domain = std::to_string(domain_);
    std::string count = std::to_string(size);
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
  Team team(size);
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

}  // namespace
}  // namespace galilean::wire
