// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "bhdl/graph/ways.h"

namespace galilean::bhdl {

/// A state's box [px], from the picture's upper left corner.
struct Box {
  const State* state = nullptr;
  std::vector<Way> ways;
  std::size_t column = 0;
  double x = 0;
  double y = 0;
  double width = 0;
  double height = 0;
};

/// A place [px] between two columns' boxes that a long arrow passes through.
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

/// Lays the graph out in layers (Sugiyama, Tagawa and Toda 1981). The layer is the distance from
/// the start state, arrows are cut at every column, and the order within a column follows the mean
/// place of the neighbours. The result is deterministic. Apart from sorting, time is linear in
/// states and arrows.
[[nodiscard]] GraphLayout lay_out_graph(const Program& program);

}  // namespace galilean::bhdl
