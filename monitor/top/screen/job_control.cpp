// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/screen/job_control.h"

#include <signal.h>
#include <sys/signalfd.h>
#include <unistd.h>

namespace galilean::monitor::top {
namespace {

sigset_t signals_of_jobs() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGTSTP);
  sigaddset(&signals, SIGCONT);
  return signals;
}

}  // namespace

JobControl::JobControl() {
  const sigset_t signals = signals_of_jobs();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  descriptor_ = signalfd(-1, &signals, SFD_NONBLOCK | SFD_CLOEXEC);
}

JobControl::~JobControl() {
  while (take() != Event::kNone) {
  }
  close(descriptor_);
  const sigset_t signals = signals_of_jobs();
  pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
}

JobControl::Event JobControl::take() noexcept {
  signalfd_siginfo signal;
  if (read(descriptor_, &signal, sizeof signal) != sizeof signal) return Event::kNone;
  return signal.ssi_signo == SIGTSTP ? Event::kStop : Event::kContinued;
}

void JobControl::stop() noexcept {
  sigset_t stopping;
  sigemptyset(&stopping);
  sigaddset(&stopping, SIGTSTP);
  raise(SIGTSTP);  // it waits until it is no longer blocked
  pthread_sigmask(SIG_UNBLOCK, &stopping, nullptr);
  pthread_sigmask(SIG_BLOCK, &stopping, nullptr);
}

}  // namespace galilean::monitor::top
