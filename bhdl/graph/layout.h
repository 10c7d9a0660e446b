// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "bhdl/graph/ways.h"

namespace galilean::bhdl {

/// A state's box, in pixels from the picture's upper left corner.
struct Box {
  const State* state = nullptr;
  std::vector<Way> ways;
  std::size_t column = 0;
  double x = 0;
  double y = 0;
  double width = 0;
  double height = 0;
};

/// A place between two columns' boxes that a long arrow passes.
struct Passage {
  double x = 0;
  double y = 0;
  double width = 0;
};

struct Arrow {
  std::size_t from = 0;  ///< box
  std::size_t way = 0;   ///< of that box
  std::size_t to = 0;    ///< box
  std::vector<Passage> passages;
};

struct GraphLayout {
  static constexpr double kRowHeight = 20;
  static constexpr double kTitleHeight = 26;
  static constexpr double kCharacterWidth = 7.3;  ///< of 12 px monospace, rounded up

  std::vector<Box> boxes;
  std::vector<Arrow> arrows;
  double width = 0;
  double height = 0;
};

/// Layers by distance from the start, arrows cut at every column (Sugiyama's way), order within a
/// column by the mean place of neighbours. Deterministic; linear in states and arrows but for
/// sorting.
[[nodiscard]] GraphLayout lay_out_graph(const Program& program);

}  // namespace galilean::bhdl
