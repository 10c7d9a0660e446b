// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "core/visible_text.h"
#include "monitor/logs/figures/map_drawing.h"
#include "monitor/logs/figures/map_extent.h"

namespace galilean::logs {
namespace {

/// A letter is about twice as high as it is wide.
constexpr double kLetterShape = 2;

/// A sheet of letters, over which metres are placed.
class LetterMap {
 public:
  LetterMap(const MapExtent& extent, std::size_t width, std::size_t height)
      : extent_(extent),
        column_m_(std::max(extent.width_m() / static_cast<double>(width),
                           extent.height_m() / (kLetterShape * static_cast<double>(height)))) {
    const auto columns = static_cast<std::size_t>(std::ceil(extent.width_m() / column_m_));
    const auto rows =
        static_cast<std::size_t>(std::ceil(extent.height_m() / (kLetterShape * column_m_)));
    rows_.assign(std::max<std::size_t>(rows, 1),
                 std::string(std::max<std::size_t>(columns, 1), ' '));
  }

  void put(const DrawnPoint& at_m, char letter) {
    const double column = (at_m.x - extent_.left_m) / column_m_;
    const double row = (extent_.top_m - at_m.y) / (kLetterShape * column_m_);
    if (column < 0 || row < 0) return;
    const auto c = static_cast<std::size_t>(column), r = static_cast<std::size_t>(row);
    if (r < rows_.size() && c < rows_[r].size()) rows_[r][c] = letter;
  }
  /// Puts into each letter what `letter_at` gives for its middle; nothing for 0.
  template <class LetterAt>
  void fill(const LetterAt& letter_at) {
    for (std::size_t row = 0; row < rows_.size(); ++row)
      for (std::size_t column = 0; column < rows_[row].size(); ++column) {
        const DrawnPoint middle{
            extent_.left_m + (static_cast<double>(column) + 0.5) * column_m_,
            extent_.top_m - (static_cast<double>(row) + 0.5) * kLetterShape * column_m_};
        if (const char letter = letter_at(middle); letter != 0) rows_[row][column] = letter;
      }
  }
  [[nodiscard]] std::string text() const {
    std::string text;
    for (const auto& row : rows_) text += row.substr(0, row.find_last_not_of(' ') + 1) + '\n';
    return text;
  }
  [[nodiscard]] double column_m() const noexcept { return column_m_; }

 private:
  MapExtent extent_;
  double column_m_;
  std::vector<std::string> rows_;
};

char floor_letter(int cell) {
  if (cell < 0) return 0;
  if (cell <= kFreeTo) return '.';
  return cell >= kOccupiedFrom ? '#' : 0;
}

/// A letter shows the cell in its middle, or one that is occupied, so that no thin wall is missed.
void put_floor(const MapFloor& floor, LetterMap& to) {
  to.fill([&](const DrawnPoint& at_m) -> char {
    const double column = (at_m.x - floor.origin_m.x) / floor.resolution_m;
    const double row = (at_m.y - floor.origin_m.y) / floor.resolution_m;
    if (column < 0 || row < 0) return 0;
    const auto c = static_cast<std::size_t>(column), r = static_cast<std::size_t>(row);
    return c < floor.width && r < floor.height ? floor_letter(floor.cells[r * floor.width + c]) : 0;
  });
  for (std::size_t i = 0; i < floor.cells.size(); ++i) {
    if (floor_letter(floor.cells[i]) != '#') continue;
    const std::size_t column = i % floor.width, row = i / floor.width;
    to.put({floor.origin_m.x + (static_cast<double>(column) + 0.5) * floor.resolution_m,
            floor.origin_m.y + (static_cast<double>(row) + 0.5) * floor.resolution_m},
           '#');
  }
}

}  // namespace

std::string map_text(const MapTracks& tracks, std::size_t width, std::size_t height) {
  LetterMap sheet(MapExtent(tracks), width, height);
  if (tracks.floor) put_floor(*tracks.floor, sheet);
  std::string legend;
  std::size_t robots = 0;
  for (const auto& [robot, track] : tracks.tracks) {
    const auto index = robots++ % 26;
    for (const auto& point : track.points_m()) sheet.put(point, static_cast<char>('a' + index));
    if (!track.points_m().empty())
      sheet.put(track.points_m().back(), static_cast<char>('A' + index));
    legend += (legend.empty() ? "" : ", ") + std::string(1, static_cast<char>('a' + index)) + ' ' +
              visible(robot);
  }
  return legend + "; capital letters are at the end; a letter is " + short_text(sheet.column_m()) +
         " m wide\n" + sheet.text();
}

}  // namespace galilean::logs
