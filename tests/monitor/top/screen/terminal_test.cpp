// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/screen/terminal.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>

namespace galilean::monitor::top {
namespace {

bool is_raw() {
  termios mode{};
  return tcgetattr(STDIN_FILENO, &mode) == 0 && (mode.c_lflag & ICANON) == 0;
}

void give_foreground_to(pid_t group) {
  sigset_t stopping;
  sigemptyset(&stopping);
  sigaddset(&stopping, SIGTTOU);
  sigprocmask(SIG_BLOCK, &stopping, nullptr);
  tcsetpgrp(STDIN_FILENO, group);
  sigprocmask(SIG_UNBLOCK, &stopping, nullptr);
}

/// Plays a job that is stopped by Ctrl-Z, continued in the background, and then brought back.
/// Returns the number of the first step that went wrong, or 0.
int play_job(pid_t shell) {
  Terminal terminal({}, false);
  if (terminal.is_entered() || is_raw()) return 1;  // it was started in the background
  give_foreground_to(getpid());
  terminal.enter();
  if (!terminal.is_entered() || !is_raw()) return 2;
  terminal.leave();
  if (terminal.is_entered() || is_raw()) return 3;
  give_foreground_to(shell);
  terminal.enter();
  if (terminal.is_entered() || is_raw()) return 4;
  give_foreground_to(getpid());
  terminal.enter();
  if (!terminal.is_entered() || !is_raw()) return 5;
  give_foreground_to(shell);
  terminal.leave();  // the mode is the shell's affair by now
  return is_raw() ? 0 : 6;
}

int exit_code_of(pid_t child) {
  int status = 0;
  waitpid(child, &status, WUNTRACED);
  if (WIFEXITED(status)) return WEXITSTATUS(status);
  kill(child, SIGKILL);  // it may have been stopped because it wrote from the background
  return 100;
}

/// Becomes a shell on the terminal of this name and runs the job in a group of its own.
int play_shell(const char* terminal) {
  setsid();
  const int descriptor = open(terminal, O_RDWR);
  ioctl(descriptor, TIOCSCTTY, 0);
  for (const int standard : {STDIN_FILENO, STDOUT_FILENO}) dup2(descriptor, standard);
  tcsetpgrp(STDIN_FILENO, getpid());
  const pid_t shell = getpid(), job = fork();
  if (job != 0) return exit_code_of(job);
  setpgid(0, 0);
  _exit(play_job(shell));
}

TEST(TerminalTest, InTheBackgroundTheTerminalIsTheShells) {
  const int master = posix_openpt(O_RDWR | O_NOCTTY);
  ASSERT_GE(master, 0);
  ASSERT_EQ(grantpt(master), 0);
  ASSERT_EQ(unlockpt(master), 0);
  const char* name = ptsname(master);
  const pid_t child = fork();
  if (child == 0) _exit(play_shell(name));
  EXPECT_EQ(exit_code_of(child), 0);
  close(master);
}

}  // namespace
}  // namespace galilean::monitor::top
