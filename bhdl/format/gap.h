// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>
#include <vector>

#include "bhdl/format/piece.h"

namespace galilean::bhdl {

/// The line breaks and comments that the author wrote between two tokens.
struct Gap {
  std::vector<Comment> comments;
  bool first_is_remark = false;  ///< the first comment begins on the line of the token before
  bool begins_line = false;      ///< the token behind is the first of its line
  bool after_blank_line = false;
};

/// Requires: `gap` holds blanks and comments alone.
[[nodiscard]] Gap read_gap(std::string_view gap);

}  // namespace galilean::bhdl
