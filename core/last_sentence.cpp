// SPDX-License-Identifier: BSD-3-Clause
#include "core/last_sentence.h"

#include <signal.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>

namespace galilean {
namespace {

const char* the_program = "galilean";

/// Needs no memory, and may be called in a signal's handler.
void write_text(const char* text) noexcept {
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text, std::strlen(text));
}

void write_sentence(const char* why) noexcept {
  write_text(the_program);
  write_text(": it ends at once, because ");
  write_text(why);
  write_text("\n");
}

void abort_without_a_word() noexcept {
  signal(SIGABRT, SIG_DFL);
  std::abort();
}

[[noreturn]] void on_terminate() noexcept {
  try {
    if (const auto fault = std::current_exception()) std::rethrow_exception(fault);
    write_sentence("a part of it failed");
  } catch (const std::bad_alloc&) {
    write_sentence("no memory is left");
    _exit(EXIT_FAILURE);
  } catch (const std::exception& error) {
    write_sentence(error.what());
  } catch (...) {
    write_sentence("it threw what is no std::exception");
  }
  abort_without_a_word();
  _exit(EXIT_FAILURE);
}

/// DDS aborts a process that has no memory left. The handler was removed as it was called, so the
/// signal that is raised again ends the process.
void on_abort(int number) {
  write_sentence("a library aborted it, as DDS does where no memory is left");
  raise(number);
}

}  // namespace

void say_why_it_ends(const char* program) noexcept {
  the_program = program;
  std::set_terminate(on_terminate);
  struct sigaction action {};
  action.sa_handler = on_abort;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(SIGABRT, &action, nullptr);
}

}  // namespace galilean
