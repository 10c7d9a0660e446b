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
  std::optional<std::string> text;  ///< set if nothing was wrong; its meaning is that of the old
                                    ///< text
  std::vector<Diagnostic> diagnostics;
};

/// Lays out one file. Included files are not read, and names need not exist. Every comment is kept.
/// Lines end as most of the text's lines do, with \n or with \r\n.
/// A text that was laid out before stays as it is. Takes time and memory linear in the text.
[[nodiscard]] Formatted format_text(const std::string& file, std::string_view text);

}  // namespace galilean::bhdl
