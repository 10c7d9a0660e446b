// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/result.h"

namespace galilean::monitor {

/// Runs `work`, and keeps an exception from ending its caller: a session, a timer that arms itself
/// anew or a thread. Writes the exception to stderr as the failure of `what`. Returns the
/// exception's message, or nothing if `work` did not throw. Exceptions that are no std::exception
/// pass through.
template <class Work>
std::optional<Error> guarded(std::string_view what, Work&& work) {
  try {
    std::forward<Work>(work)();
    return std::nullopt;
  } catch (const std::exception& error) {
    std::clog << "galilean-monitor: " + std::string(what) + " failed: " + error.what() + "\n"
              << std::flush;
    return Error{error.what()};
  }
}

}  // namespace galilean::monitor
