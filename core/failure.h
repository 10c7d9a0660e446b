// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <string>

namespace galilean {

/// Returns `text`, or "for an unknown reason" if it is empty, or "out of memory" if it cannot be
/// copied. The result is never empty.
[[nodiscard]] std::string text_of(const char* text) noexcept;

/// Does `work`. Returns what it threw, in words, or an empty text if it threw nothing.
template <class Work>
[[nodiscard]] std::string failure_of(Work&& work) noexcept {
  try {
    work();
    return {};
  } catch (const std::exception& failure) {
    return text_of(failure.what());
  } catch (...) {
    return text_of("");
  }
}

}  // namespace galilean
