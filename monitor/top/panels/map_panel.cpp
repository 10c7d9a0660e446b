// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include "monitor/top/panels/panels.h"
#include "monitor/top/panels/whole_number.h"
#include "monitor/top/screen/utf8.h"

namespace galilean::monitor::top {
namespace {

constexpr double kCellAspect = 2;  // height by width of a terminal's cell
constexpr double kMargin_m = 0.5, kLeastWidth_m = 4;
constexpr double kUnsure = 0.33;

/// An axis-parallel box around the shown objects, robots and known cells, in metres.
struct Bounds {
  Vec2 low{1e9, 1e9}, high{-1e9, -1e9};

  void include(const Vec2& point) {
    if (!point.allFinite()) return;
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
};

Bounds bounds_of(const View& view) {
  Bounds bounds;
  for (const auto& object : view.objects) bounds.include(object.position_m);
  for (const auto& robot : view.poses) bounds.include(robot.pose.position_m);
  if (view.floor)
    for (const auto& run : view.floor->runs())
      for (const auto column : {run.first, run.end - 1})
        bounds.include({view.floor->x_m(column), view.floor->y_m(run.row)});
  if (bounds.low.x() > bounds.high.x()) bounds = {{0, 0}, {0, 0}};
  const Vec2 center = (bounds.low + bounds.high) / 2;
  const Vec2 half = ((bounds.high - bounds.low) / 2 + Vec2(kMargin_m, kMargin_m))
                        .cwiseMax(Vec2(kLeastWidth_m / 2, kLeastWidth_m / 2));
  return {center - half, center + half};
}

/// Maps points of the floor [m] to cells of the canvas: one scale for both axes, the y axis up, the
/// bounds in the middle of the area.
class Projection {
 public:
  Projection(const Bounds& bounds, const Area& area) : area_(area) {
    const Vec2 size = bounds.high - bounds.low;
    metres_a_column_ = std::max(size.x() / area.columns, size.y() / (area.rows * kCellAspect));
    center_m_ = (bounds.low + bounds.high) / 2;
  }
  /// Returns the column, and which of the `parts` equal parts of it the point lies in.
  [[nodiscard]] std::pair<int, int> column_and_part(double x_m, int parts) const {
    return split(area_.column, (x_m - center_m_.x()) / metres_a_column_ + area_.columns / 2.0,
                 parts);
  }
  [[nodiscard]] std::pair<int, int> row_and_part(double y_m, int parts) const {
    return split(area_.row,
                 (center_m_.y() - y_m) / (metres_a_column_ * kCellAspect) + area_.rows / 2.0,
                 parts);
  }
  [[nodiscard]] int column(double x_m) const { return column_and_part(x_m, 1).first; }
  [[nodiscard]] int row(double y_m) const { return row_and_part(y_m, 1).first; }
  [[nodiscard]] bool within(int row, int column) const {
    return row >= area_.row && row < area_.row + area_.rows && column >= area_.column &&
           column < area_.column + area_.columns;
  }
  [[nodiscard]] double metres_a_column() const { return metres_a_column_; }

 private:
  static std::pair<int, int> split(int begin, double cells, int parts) {
    const double whole = std::floor(cells);
    constexpr int kFarOutside = 100'000;
    return {begin + whole_number(whole, -kFarOutside, kFarOutside),
            whole_number(std::floor((cells - whole) * parts), 0, parts - 1)};
  }

  Area area_;
  Vec2 center_m_;
  double metres_a_column_;
};

void put_within(const Projection& projection, int row, int column, char32_t glyph, Style style,
                Canvas& canvas) {
  if (projection.within(row, column)) canvas.set(row, column, glyph, style);
}

/// Returns the bit of a Braille character for the dot in this row (of 4) and column (of 2).
char32_t dot(int row, int column) {
  constexpr std::array<char32_t, 8> kDots{0x01, 0x08, 0x02, 0x10, 0x04, 0x20, 0x40, 0x80};
  return kDots[static_cast<std::size_t>(row * 2 + column)];
}

/// Draws what is occupied as Braille dots, eight to a cell of the screen, and what is free as "·".
void draw_floor(const Floor& floor, const Projection& projection, Canvas& canvas) {
  constexpr char32_t kNoDots = 0x2800;
  std::vector<std::pair<int, int>> columns;  // of the screen, and dots in them, of each of the grid
  for (std::uint32_t i = 0; i < floor.columns(); ++i)
    columns.push_back(projection.column_and_part(floor.x_m(i), 2));
  for (const auto& run : floor.runs()) {
    const auto [row, dot_row] = projection.row_and_part(floor.y_m(run.row), 4);
    std::pair<int, int> drawn{-1, -1};
    for (auto i = run.first; i < run.end; ++i) {
      if (columns[i] == drawn) continue;
      drawn = columns[i];
      const auto [column, dot_column] = drawn;
      if (!projection.within(row, column)) continue;
      const char32_t before = canvas.at(row, column).glyph;
      const char32_t dots = before >= kNoDots && before <= kNoDots + 0xff ? before : kNoDots;
      if (run.occupied)
        canvas.set(row, column, dots | dot(dot_row, dot_column), Style::kPlain);
      else if (before == U' ')
        canvas.set(row, column, U'·', Style::kDim);
    }
  }
}

struct Symbol {
  char32_t glyph;
  Style style;
};

Symbol symbol_of(const std::string& object_class) {
  if (object_class == "trash") return {U'*', Style::kTrash};
  if (object_class == "basket") return {U'U', Style::kBasket};
  return {U'o', Style::kObstacle};
}

void draw_robot(const ShownRobot& robot, const ShownPose& shown, const Projection& projection,
                Canvas& canvas) {
  static constexpr std::array<char32_t, 8> kArrows{U'→', U'↗', U'↑', U'↖', U'←', U'↙', U'↓', U'↘'};
  static constexpr std::array<int, 8> kRight{1, 1, 0, -1, -1, -1, 0, 1};
  static constexpr std::array<int, 8> kDown{0, -1, -1, -1, 0, 1, 1, 1};
  if (!shown.pose.position_m.allFinite() || !std::isfinite(shown.pose.heading_rad)) return;
  const int row = projection.row(shown.pose.position_m.y());
  const int column = projection.column(shown.pose.position_m.x());
  const long eighth = std::lround(wrap_angle(shown.pose.heading_rad) / (kPi / 4));
  const auto sector = static_cast<std::size_t>((eighth + 8) % 8);
  const Style style =
      robot.status.health == Health::kSilent ? Style::kDim : robot_style(robot.number);
  put_within(projection, row + kDown[sector], column + kRight[sector], kArrows[sector], style,
             canvas);
  std::string_view letters = robot.letter;
  for (int right = 0; !letters.empty(); ++right)
    put_within(projection, row, column + right, take_character(letters), style, canvas);
}

/// Draws the map's title, and its scale if there is room.
void draw_heading(const std::string& title, const Projection& projection, const Area& area,
                  Canvas& canvas) {
  const int end = canvas.put(area.row, area.column, title, Style::kHeading, area.columns);
  std::array<char, 40> scale{};
  std::snprintf(scale.data(), scale.size(), "%.2f m a column", projection.metres_a_column());
  const int right = area.column + area.columns;
  if (right - end > width_of(scale.data()))
    canvas.put_right(area.row, right, scale.data(), Style::kDim);
}

}  // namespace

void draw_map(const View& view, const Area& area, Canvas& canvas) {
  if (area.rows < 3 || area.columns < 8) return;
  const Area inside{area.row + 1, area.column, area.rows - 2, area.columns};
  const Projection projection(bounds_of(view), inside);
  draw_heading(view.map_title, projection, area, canvas);
  if (view.floor) draw_floor(*view.floor, projection, canvas);
  for (const auto& object : view.objects) {
    if (!object.position_m.allFinite()) continue;
    const Symbol symbol = symbol_of(object.object_class);
    put_within(projection, projection.row(object.position_m.y()),
               projection.column(object.position_m.x()), symbol.glyph,
               object.certainty < kUnsure ? Style::kDim : symbol.style, canvas);
  }
  for (const auto& pose : view.poses) draw_robot(view.robots[pose.robot], pose, projection, canvas);
  canvas.put(area.row + area.rows - 1, area.column, "* trash  U basket  o obstacle", Style::kDim,
             area.columns);
}

}  // namespace galilean::monitor::top
