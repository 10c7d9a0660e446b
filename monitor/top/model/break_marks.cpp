// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/model/break_marks.h"

#include <algorithm>

namespace galilean::monitor::top {
namespace {

/// Returns the mark of the points for which `is_there` holds. Of several a lock counts most.
template <class Condition>
BreakMark mark_where(const std::optional<msg::Breaks>& breaks, Condition is_there) {
  BreakMark mark = BreakMark::kNone;
  if (!breaks) return mark;
  for (const auto& point : breaks->points)
    if (is_there(point)) mark = std::max(mark, mark_of(point.kind));
  return mark;
}

}  // namespace

BreakMark mark_of(std::uint8_t kind) noexcept {
  switch (kind) {
    case msg::BreakPoint_Constants::STOP:
      return BreakMark::kStop;
    case msg::BreakPoint_Constants::STOP_TEAM:
      return BreakMark::kStopTeam;
    case msg::BreakPoint_Constants::LOCK:
      return BreakMark::kLock;
    default:
      return BreakMark::kNone;
  }
}

BreakMark mark_on_entering(const std::optional<msg::Breaks>& breaks, std::string_view state) {
  return mark_where(breaks, [&](const msg::BreakPoint& point) {
    return point.from_state.empty() && point.to_state == state;
  });
}

BreakMark mark_at(const std::optional<msg::Breaks>& breaks, std::string_view from,
                  std::string_view to) {
  return mark_where(breaks, [&](const msg::BreakPoint& point) {
    return point.from_state == from && (point.to_state.empty() || point.to_state == to);
  });
}

}  // namespace galilean::monitor::top
