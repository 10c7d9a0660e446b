// SPDX-License-Identifier: BSD-3-Clause
#include "core/termination.h"

#include <pthread.h>
#include <signal.h>
#include <sys/signalfd.h>
#include <unistd.h>

namespace galilean {
namespace {

bool is_ignored(int signal) {
  struct sigaction action {};
  return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

sigset_t set_of(bool with_hangup) {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  if (with_hangup) sigaddset(&signals, SIGHUP);
  return signals;
}

}  // namespace

Termination::Termination() {
  const sigset_t signals = set_of(!is_ignored(SIGHUP));
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  descriptor_ = signalfd(-1, &signals, SFD_NONBLOCK | SFD_CLOEXEC);
}

Termination::~Termination() {
  // A signal that is still pending would end the process as soon as it is unblocked.
  static_cast<void>(asked());
  close(descriptor_);
  unblock();
}

void Termination::unblock() noexcept {
  const sigset_t signals = set_of(true);
  pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
}

bool Termination::asked() noexcept {
  signalfd_siginfo signal;
  while (read(descriptor_, &signal, sizeof signal) == sizeof signal) asked_ = true;
  return asked_;
}

}  // namespace galilean
