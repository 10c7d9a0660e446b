// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/front/process.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <deque>
#include <fstream>
#include <thread>
#include <utility>

#include "core/private_file.h"
#include "core/termination.h"

namespace galilean::front {
namespace {

constexpr auto kPatience = std::chrono::seconds(8);
constexpr auto kLookEach = std::chrono::milliseconds(10);
constexpr int kNotStarted = 127;

/// Turns the forked child into the program. Must not allocate, because another thread may have held
/// the allocator's lock at the fork.
[[noreturn]] void become(char* const* command, int log, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(kNotStarted);  // the parent died before prctl
  setpgid(0, 0);
  Termination::unblock();
  const int nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, STDIN_FILENO);
  dup2(log, STDOUT_FILENO);
  dup2(log, STDERR_FILENO);
  execv(command[0], command);
  const char* reason = std::strerror(errno);
  if (write(STDERR_FILENO, reason, std::strlen(reason)) < 0) _exit(kNotStarted);
  _exit(kNotStarted);
}

}  // namespace

Result<Process> Process::start(std::string name, const std::vector<std::string>& command,
                               const std::filesystem::path& log) {
  // A monitor's log holds the link with its token, so logs are for their owner alone.
  const auto opened = open_private_file(log, O_WRONLY | O_APPEND);
  if (!opened) return opened.error();
  const int file = opened.value();
  std::vector<char*> arguments;
  for (const auto& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const pid_t parent = getpid();
  const pid_t pid = fork();
  if (pid == 0) become(arguments.data(), file, parent);
  const int problem = errno;
  close(file);
  if (pid < 0) return Error{name + " cannot be started: " + std::strerror(problem)};
  return Process(std::move(name), log, pid);
}

Process::Process(Process&& other) noexcept
    : name_(std::move(other.name_)),
      log_(std::move(other.log_)),
      pid_(std::exchange(other.pid_, 0)),
      status_(other.status_) {}

Process::~Process() {
  if (pid_ == 0) return;
  ask_to_end();
  end();
}

bool Process::running() {
  if (status_) return false;
  int status = 0;
  if (waitpid(pid_, &status, WNOHANG) == pid_) status_ = status;
  return !status_;
}

std::string Process::ending() const {
  if (!status_) return {};
  if (WIFSIGNALED(*status_))
    return "killed by signal " + std::to_string(WTERMSIG(*status_)) + " (" +
           strsignal(WTERMSIG(*status_)) + ")";
  return "exit code " + std::to_string(WEXITSTATUS(*status_));
}

std::optional<int> Process::exit_code() const noexcept {
  if (!status_ || !WIFEXITED(*status_)) return std::nullopt;
  return WEXITSTATUS(*status_);
}

bool Process::ended_well() const noexcept {
  return exit_code() == 0;
}

void Process::ask_to_end() noexcept {
  if (running()) kill(pid_, SIGTERM);
}

bool Process::end() {
  const auto deadline = std::chrono::steady_clock::now() + kPatience;
  while (running() && std::chrono::steady_clock::now() < deadline)
    std::this_thread::sleep_for(kLookEach);
  if (!running()) return true;
  kill(pid_, SIGKILL);
  int status = 0;
  while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  status_ = status;
  return false;
}

std::string last_lines(const std::filesystem::path& log, std::size_t count) {
  std::ifstream in(log);
  std::deque<std::string> lines;
  for (std::string line; std::getline(in, line);) {
    lines.push_back(line);
    if (lines.size() > count) lines.pop_front();
  }
  std::string text;
  for (const auto& line : lines) text += "    " + line + "\n";
  return text;
}

std::optional<std::string> line_with(const std::filesystem::path& log, std::string_view mark) {
  std::ifstream in(log);
  for (std::string line; std::getline(in, line) && !in.eof();)
    if (line.find(mark) != std::string::npos) return line;
  return {};
}

}  // namespace galilean::front
