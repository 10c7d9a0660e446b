// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <string>

namespace galilean {

/// Returns a string that is never empty: `text`, where there is one and memory for it.
[[nodiscard]] std::string text_of(const char* text) noexcept;

/// Does `work`. Returns what it threw, in words; empty if it threw nothing.
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
