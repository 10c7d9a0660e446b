#include "core/termination.h"

#include <pthread.h>
#include <signal.h>
#include <sys/signalfd.h>
#include <unistd.h>

namespace galilean {
namespace {

sigset_t both() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  return signals;
}

}  // namespace

Termination::Termination() {
  const sigset_t signals = both();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  descriptor_ = signalfd(-1, &signals, SFD_NONBLOCK | SFD_CLOEXEC);
}

Termination::~Termination() {
  close(descriptor_);
  const sigset_t signals = both();
  pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
}

bool Termination::asked() noexcept {
  signalfd_siginfo signal;
  while (read(descriptor_, &signal, sizeof signal) == sizeof signal) asked_ = true;
  return asked_;
}

}  // namespace galilean
