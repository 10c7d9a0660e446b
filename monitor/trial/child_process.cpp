// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/trial/child_process.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace galilean::monitor {
namespace {

constexpr int kNotStarted = 127;

constexpr int kNiceness = 10;
constexpr rlim_t kMostFileBytes = rlim_t{8} << 20;

/// Lets the child have what others leave: processor time, room on the disk, and no dump of its
/// memory. Where memory is short, the kernel ends the child first. What cannot be set stays as it
/// is. Must not allocate.
void be_modest() {
  (void)setpriority(PRIO_PROCESS, 0, kNiceness);
  const rlimit files{kMostFileBytes, kMostFileBytes}, dumps{0, 0};
  (void)setrlimit(RLIMIT_FSIZE, &files);
  (void)setrlimit(RLIMIT_CORE, &dumps);
  const int score = open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC);
  if (score < 0) return;
  [[maybe_unused]] const auto written = ::write(score, "1000", 4);
  close(score);
}

/// Turns the forked child into the program. Must not allocate, because another thread may have held
/// the allocator's lock at the fork.
[[noreturn]] void become(char* const* command, const char* out, const char* err, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(kNotStarted);  // the parent died before prctl
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  setpgid(0, 0);
  be_modest();
  const int nothing = open("/dev/null", O_RDONLY);
  // As open_private_file does, which allocates.
  const int to_out = open(out, O_WRONLY | O_CREAT | O_TRUNC, 0600);
  const int to_err = open(err, O_WRONLY | O_CREAT | O_TRUNC, 0600);
  dup2(nothing, STDIN_FILENO);
  dup2(to_out, STDOUT_FILENO);
  dup2(to_err, STDERR_FILENO);
  close_range(STDERR_FILENO + 1, ~0U, 0);
  execv(command[0], command);
  const char* why = std::strerror(errno);
  if (::write(STDERR_FILENO, why, std::strlen(why)) < 0) _exit(kNotStarted);
  _exit(kNotStarted);
}

}  // namespace

Result<std::unique_ptr<ChildProcess>> ChildProcess::start(boost::asio::io_context& io,
                                                          const std::vector<std::string>& command,
                                                          const std::filesystem::path& out,
                                                          const std::filesystem::path& err,
                                                          Ended ended) {
  std::vector<char*> arguments;
  for (const auto& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const pid_t parent = getpid();
  const pid_t pid = fork();
  if (pid == 0) become(arguments.data(), out.c_str(), err.c_str(), parent);
  if (pid < 0) return Error{command[0] + " cannot be started: " + std::strerror(errno)};
  const int descriptor = static_cast<int>(syscall(SYS_pidfd_open, pid, 0));
  if (descriptor < 0) {
    const std::string why = std::strerror(errno);
    kill(pid, SIGKILL);
    waitpid(pid, nullptr, 0);
    return Error{command[0] + " cannot be waited for: " + why};
  }
  return std::unique_ptr<ChildProcess>(new ChildProcess(io, pid, descriptor, std::move(ended)));
}

ChildProcess::ChildProcess(boost::asio::io_context& io, pid_t pid, int descriptor, Ended ended)
    : pid_(pid), readable_when_over_(io, descriptor), ended_(std::move(ended)) {
  wait();
}

ChildProcess::~ChildProcess() {
  *alive_ = false;
  if (pid_ == 0) return;
  kill(pid_, SIGKILL);
  (void)reap();
}

void ChildProcess::wait() {
  readable_when_over_.async_wait(boost::asio::posix::stream_descriptor::wait_read,
                                 [this, alive = alive_](boost::system::error_code error) {
                                   if (error || !*alive) return;
                                   const int exit_code = reap();
                                   const auto ended = std::exchange(ended_, nullptr);
                                   ended(exit_code);
                                 });
}

int ChildProcess::reap() {
  int status = 0;
  while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = 0;
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace galilean::monitor
