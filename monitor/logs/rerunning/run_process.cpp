// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/rerunning/run_process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

extern char** environ;

namespace galilean::logs {
namespace {

/// Starts the program with `input` as its standard input. Returns an error number.
int spawn(const std::vector<std::string>& command, int input, pid_t& pid) {
  std::vector<char*> arguments;
  for (const auto& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  const int problem =
      posix_spawn(&pid, command[0].c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return problem;
}

}  // namespace

/// No other process may hold the end that is written to: its reader would never see the end.
Result<std::unique_ptr<RunProcess>> RunProcess::start(const std::vector<std::string>& command) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) < 0)
    return Error{std::string("no pipe can be made: ") + std::strerror(errno)};
  pid_t pid = 0;
  const int problem = spawn(command, ends[0], pid);
  close(ends[0]);
  if (problem == 0) return std::unique_ptr<RunProcess>(new RunProcess(pid, ends[1]));
  close(ends[1]);
  return Error{command[0] + " cannot be started: " + std::strerror(problem)};
}

RunProcess::~RunProcess() {
  if (pid_ != 0) static_cast<void>(finish());
}

void RunProcess::send(std::span<const std::uint8_t> message) {
  std::array<std::uint8_t, 4> length{};
  for (std::size_t i = 0; i < length.size(); ++i)
    length[i] = static_cast<std::uint8_t>(message.size() >> 8 * i);
  write_all(length);
  write_all(message);
}

void RunProcess::write_all(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty() && input_ >= 0) {
    const ssize_t written = write(input_, bytes.data(), bytes.size());
    if (written >= 0)
      bytes = bytes.subspan(static_cast<std::size_t>(written));
    else if (errno != EINTR)
      end_input();
  }
}

void RunProcess::end_input() {
  if (input_ >= 0) close(input_);
  input_ = -1;
}

Result<int> RunProcess::finish() {
  end_input();
  int status = 0;
  while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = 0;
  if (WIFEXITED(status)) return WEXITSTATUS(status);
  return Error{std::string("it was ended by ") + strsignal(WTERMSIG(status))};
}

}  // namespace galilean::logs
