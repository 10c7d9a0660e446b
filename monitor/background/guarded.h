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

/// Runs `work`, where an exception would otherwise end what runs it: a session, a timer that arms
/// itself anew, a thread. What is thrown is told on stderr, once, as the failure of `what`.
/// Errors: what was thrown. Nothing, if all went well.
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
