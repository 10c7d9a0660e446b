// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bhdl/source/diagnostic.h"

namespace galilean::bhdl {

/// A file's text in the one layout that GRAMMAR.md describes, or every reason why there is none.
struct Formatted {
  std::optional<std::string> text;  ///< set if nothing was wrong; it means what it meant before
  std::vector<Diagnostic> diagnostics;
};

/// Lays out one file; what it includes is not looked at, and names need not exist. Every comment is
/// kept. Formatting what was formatted changes nothing. Takes time and memory linear in the text.
[[nodiscard]] Formatted format_text(const std::string& file, std::string_view text);

}  // namespace galilean::bhdl
