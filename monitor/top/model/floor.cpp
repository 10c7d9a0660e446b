// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/model/floor.h"

#include <algorithm>
#include <span>

namespace galilean::monitor::top {
namespace {

constexpr std::int8_t kOccupiedPercent = 65, kFreePercent = 35;

bool is_occupied(std::int8_t percent) {
  return percent >= kOccupiedPercent;
}
bool is_known(std::int8_t percent) {
  return is_occupied(percent) || (percent >= 0 && percent <= kFreePercent);
}
bool are_alike(std::int8_t a, std::int8_t b) {
  return is_known(b) && is_occupied(a) == is_occupied(b);
}

}  // namespace

Floor::Floor(const msg::OccupancyGrid& grid)
    : x_m_(grid.info.origin.position.x),
      y_m_(grid.info.origin.position.y),
      resolution_m_(grid.info.resolution) {
  const std::uint32_t width = grid.info.width;
  std::span<const std::int8_t> rest(grid.data);
  for (std::uint32_t row = 0; row < grid.info.height && width > 0 && !rest.empty(); ++row) {
    const auto cells = rest.first(std::min<std::size_t>(width, rest.size()));
    rest = rest.subspan(cells.size());
    for (std::uint32_t first = 0, end = 0; first < cells.size(); first = end) {
      end = first + 1;
      if (!is_known(cells[first])) continue;
      while (end < cells.size() && are_alike(cells[first], cells[end])) ++end;
      runs_.push_back({row, first, end, is_occupied(cells[first])});
      columns_ = std::max(columns_, end);
    }
  }
}

}  // namespace galilean::monitor::top
