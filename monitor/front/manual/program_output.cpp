// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/front/manual/program_output.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

namespace galilean::front {
namespace {

/// A pipe whose ends the child does not inherit, but for its standard output.
class OutputPipe {
 public:
  OutputPipe() { made_ = pipe2(ends_.data(), O_CLOEXEC) == 0; }
  OutputPipe(const OutputPipe&) = delete;
  OutputPipe& operator=(const OutputPipe&) = delete;
  ~OutputPipe() {
    if (made_) close(ends_[0]);
    close_input();
  }

  [[nodiscard]] bool made() const noexcept { return made_; }
  [[nodiscard]] int input() const noexcept { return ends_[1]; }
  void close_input() noexcept {
    if (made_ && ends_[1] >= 0) close(ends_[1]);
    ends_[1] = -1;
  }
  /// Returns all that is written until the last writer closes the pipe.
  [[nodiscard]] std::string read_all() const {
    std::string text;
    std::array<char, 1 << 16> part;
    for (;;) {
      const auto count = read(ends_[0], part.data(), part.size());
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return text;
      text.append(part.data(), static_cast<std::size_t>(count));
    }
  }

 private:
  std::array<int, 2> ends_{-1, -1};
  bool made_ = false;
};

/// Returns 0 if the program was started, and the error number otherwise.
int spawn(const std::vector<std::string>& command, int output, pid_t& pid) {
  std::vector<char*> arguments;
  for (const auto& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  const int problem = posix_spawn(&pid, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return problem;
}

}  // namespace

Result<std::string> program_output(const std::vector<std::string>& command) {
  OutputPipe pipe;
  if (!pipe.made()) return Error{std::string("no pipe can be made: ") + std::strerror(errno)};
  pid_t pid = 0;
  if (const int problem = spawn(command, pipe.input(), pid); problem != 0)
    return Error{command[0] + " cannot be started: " + std::strerror(problem)};
  pipe.close_input();
  std::string text = pipe.read_all();
  int status = 0;
  while (waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return Error{command[0] + " failed"};
  return text;
}

}  // namespace galilean::front
