// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bhdl/source/diagnostic.h"
#include "monitor/expect/language/expectation.h"

namespace galilean::expect {

/// Files that are larger are refused.
inline constexpr std::size_t kMostBytes = 1 << 20;

struct Parsed {
  std::vector<Expectation> expectations;  ///< those that are whole
  std::vector<bhdl::Diagnostic> diagnostics;

  [[nodiscard]] bool ok() const noexcept { return !bhdl::any_error(diagnostics); }
};

/// Reads expectations. Any text may be given. A mistake costs the claim that it is in; the others
/// are read all the same. `file` is the name that diagnostics use.
[[nodiscard]] Parsed parse(const std::string& file, std::string_view text);

}  // namespace galilean::expect
