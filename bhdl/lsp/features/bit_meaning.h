// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "bhdl/lsp/documents/spot.h"
#include "bhdl/lsp/protocol/session.h"

namespace galilean::bhdl::lsp {

/// A bit at the cursor: `bit_index: 3`, beside `bits_variable: "bumpers"`.
struct BitAt {
  std::string variable;
  int index = 0;
};
[[nodiscard]] std::optional<BitAt> bit_at(const Spot& spot);

/// Returns which schemas of the program write the bit, and what they say that they do. It is
/// Markdown, one line for each schema.
[[nodiscard]] std::string writers_in_words(const Session& session, const std::string& path,
                                           const BitAt& bit);

}  // namespace galilean::bhdl::lsp
