// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <iostream>
#include <string>
#include <string_view>
#include <utility>

#include "core/result.h"

namespace galilean::monitor {

/// Runs `work`, and keeps an exception from ending its caller: a session, a timer that arms itself
/// anew or a thread. Writes the exception to stderr as the failure of `what`. Exceptions that
/// are no std::exception pass through.
/// Errors: `work` threw; the error is the exception's message.
template <class Work>
Result<void> guarded(std::string_view what, Work&& work) {
  try {
    std::forward<Work>(work)();
    return {};
  } catch (const std::exception& error) {
    std::clog << "galilean-monitor: " + std::string(what) + " failed: " + error.what() + "\n"
              << std::flush;
    return Error{error.what()};
  }
}

}  // namespace galilean::monitor
