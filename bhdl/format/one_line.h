// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bhdl/format/piece.h"

namespace galilean::bhdl {

using Pieces = std::vector<Piece>;

/// The gap between attributes on one line. Values stand one blank apart.
inline constexpr std::string_view kAttributeGap = "  ";

/// The part of a one-line block behind its label.
struct OneLineBlock {
  std::vector<std::string> cells;
  std::string shape;  ///< its label and its attributes' names; empty if it holds other blocks
};

[[nodiscard]] OneLineBlock one_line_block_at(const Pieces& pieces, std::size_t opened);

/// Returns whether the author wrote the block on one line and it fits there.
[[nodiscard]] bool fits_one_line(const Pieces& pieces, std::size_t opened, std::size_t indent);

/// Returns the last piece of a block that is written.
[[nodiscard]] std::size_t last_written(const Pieces& pieces, std::size_t opened);

/// Returns the index behind the attribute's last value.
[[nodiscard]] std::size_t end_of_attribute(const Pieces& pieces, std::size_t name);

/// Returns the texts of the pieces, one blank apart.
[[nodiscard]] std::string joined(const Pieces& pieces, std::size_t from, std::size_t end);

}  // namespace galilean::bhdl
