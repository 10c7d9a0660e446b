// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <string_view>
#include <utility>

#include "core/result.h"

namespace galilean::monitor {

/// How often something failed in this process because no memory was left. /metrics tells it.
inline std::atomic<std::uint64_t> memory_failures = 0;

/// Writes to stderr that `what` failed. It is no failure of its own if that is not possible.
inline void tell_failure(std::string_view what, std::string_view why) noexcept {
  try {
    std::string line = "galilean-monitor: ";
    line.append(what).append(" failed: ").append(why).append("\n");
    std::clog << line << std::flush;
  } catch (...) {  // no memory for a line
  }
}

/// Runs `work`, and keeps an exception from ending its caller: a session, a timer that arms itself
/// anew or a thread. Writes the exception to stderr as the failure of `what`; that no memory is
/// left is written once only.
/// Errors: `work` threw; the error is the exception's message.
template <class Work>
Result<void> guarded(std::string_view what, Work&& work) {
  try {
    std::forward<Work>(work)();
    return {};
  } catch (const std::bad_alloc&) {
    if (memory_failures.fetch_add(1) == 0) tell_failure(what, "no memory is left");
    return Error{"out of memory"};  // short enough to need none
  } catch (const std::exception& error) {
    tell_failure(what, error.what());
    return Error{error.what()};
  } catch (...) {
    tell_failure(what, "it threw what is no std::exception");
    return Error{"an unknown fault"};
  }
}

}  // namespace galilean::monitor
