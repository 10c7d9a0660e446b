// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace galilean::monitor::top {

/// The meaning of a cell. The terminal decides how it looks.
enum class Style : std::uint8_t {
  kPlain,
  kDim,
  kBold,
  kHeading,
  kCurrent,
  kWarning,
  kAlarm,
  kGood,
  kStop,  ///< the order to stop all, and who has not confirmed it
  kTrash,
  kBasket,
  kObstacle,
  kRobot  ///< the first robot's style; kRobotStyles styles follow each other from here
};
inline constexpr int kRobotStyles = 6;
/// Returns the style of the robot with this number. Robots share styles if there are more of them.
[[nodiscard]] Style robot_style(std::size_t number) noexcept;

struct Cell {
  char32_t glyph = U' ';
  Style style = Style::kPlain;

  bool operator==(const Cell&) const = default;
};

/// A rectangle of a canvas, in cells.
struct Area {
  int row = 0, column = 0, rows = 0, columns = 0;

  [[nodiscard]] bool contains(int at_row, int at_column) const noexcept {
    return at_row >= row && at_row < row + rows && at_column >= column &&
           at_column < column + columns;
  }
};

/// A screen of text in memory. Cells outside of it are ignored.
class Canvas {
 public:
  static constexpr int kWhole = std::numeric_limits<int>::max();

  Canvas(int columns, int rows);

  /// Writes UTF-8 text from (row, column) on, at most `width` cells. Returns the column behind it.
  /// Names come over the network, so characters that could move the cursor or are not one cell wide
  /// become '?'.
  int put(int row, int column, std::string_view text, Style style = Style::kPlain,
          int width = kWhole);
  /// Writes the text so that it ends before `column`.
  void put_right(int row, int column, std::string_view text, Style style = Style::kPlain);
  void set(int row, int column, char32_t glyph, Style style);
  /// Fills an area with blanks in one style.
  void fill(const Area& area, Style style);

  [[nodiscard]] int columns() const noexcept { return columns_; }
  [[nodiscard]] int rows() const noexcept { return rows_; }
  /// Requires: the cell is on the screen.
  [[nodiscard]] const Cell& at(int row, int column) const { return cells_[index(row, column)]; }
  /// Returns the row as UTF-8, without the blanks at its end.
  [[nodiscard]] std::string line(int row) const;
  /// Returns the lines down to the last that is not empty, each with a line feed.
  [[nodiscard]] std::string text() const;

 private:
  [[nodiscard]] std::size_t index(int row, int column) const noexcept {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }

  int columns_, rows_;
  std::vector<Cell> cells_;
};

}  // namespace galilean::monitor::top
