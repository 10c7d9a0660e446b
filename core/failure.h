// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <string>

#include "core/result.h"

namespace galilean {

/// Returns `text`, or "for an unknown reason" if it is empty, or "out of memory" if it cannot be
/// copied. The result is never empty.
[[nodiscard]] std::string text_of(const char* text) noexcept;

/// Does `work`. Errors: `work` threw; the error says what, in words, and is never empty.
template <class Work>
Result<void> attempt(Work&& work) noexcept {
  try {
    work();
    return {};
  } catch (const std::exception& failure) {
    return Error{text_of(failure.what())};
  } catch (...) {
    return Error{text_of("")};
  }
}

}  // namespace galilean
