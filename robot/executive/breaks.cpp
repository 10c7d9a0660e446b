// SPDX-License-Identifier: BSD-3-Clause
#include "robot/executive/breaks.h"

#include <algorithm>
#include <utility>

namespace galilean::robot {
namespace {

/// An event may name a point for as long as the publisher has not taken it.
constexpr std::size_t kTakenOffKept = 64;

template <class Points>
auto find_at(Points& points, const StateChange& at) {
  return std::ranges::find(points, at, &BreakPoint::at);
}

Result<void> check_pass(const StateChange& change, const std::vector<BreakPoint>& points,
                        std::string_view state) {
  const bool any_lock = std::ranges::any_of(points, [&](const BreakPoint& point) {
    return point.kind == BreakKind::kLock && point.at.overlaps(change);
  });
  if (!any_lock) return Error{"there is no lock " + in_words(change)};
  if (!change.from_state.empty() && change.from_state != state)
    return Error{"it is in " + std::string(state) + ", and not in " + change.from_state +
                 ": let it through when it waits there"};
  return {};
}

}  // namespace

Result<void> Breaks::set(const std::vector<BreakPoint>& points) {
  const std::lock_guard lock(mutex_);
  std::vector<StateChange> places;
  for (const BreakPoint& point : kept_.points) places.push_back(point.at);
  for (const BreakPoint& point : points) {
    if (point.at == StateChange{})
      return Error{"a break point must name the state that is left, or the one that is entered"};
    if (std::ranges::find(places, point.at) == places.end()) places.push_back(point.at);
  }
  if (places.size() > BreakTable::kMostPoints)
    return Error{"it would have " + std::to_string(places.size()) + " break points, and " +
                 std::to_string(BreakTable::kMostPoints) + " are the most: take some off first"};
  for (const BreakPoint& point : points) set_one(point);
  publish();
  return {};
}

void Breaks::set_one(BreakPoint point) {
  point.number = ++last_point_;
  // A lock that is set anew is shut, whatever was let through before.
  if (point.kind == BreakKind::kLock)
    std::erase_if(kept_.passes, [&](const LockPass& pass) { return pass.at.overlaps(point.at); });
  const auto same = find_at(kept_.points, point.at);
  if (same == kept_.points.end())
    kept_.points.push_back(std::move(point));
  else
    taken_off_.push_back(std::exchange(*same, std::move(point)));
}

Result<void> Breaks::remove(const std::vector<StateChange>& changes) {
  const std::lock_guard lock(mutex_);
  const std::size_t before = kept_.points.size();
  for (const StateChange& change : changes) {
    const auto found = find_at(kept_.points, change);
    if (found == kept_.points.end()) continue;
    taken_off_.push_back(std::move(*found));
    kept_.points.erase(found);
  }
  if (kept_.points.size() == before)
    return Error{changes.size() == 1 ? "there is no break point " + in_words(changes.front())
                                     : "there is none of these break points"};
  publish();
  return {};
}

void Breaks::clear() {
  const std::lock_guard lock(mutex_);
  std::ranges::move(kept_.points, std::back_inserter(taken_off_));
  kept_ = {.number = kept_.number};
  publish();
}

Result<void> Breaks::let_through(const std::vector<StateChange>& changes, std::string_view state) {
  const std::lock_guard lock(mutex_);
  for (const StateChange& change : changes)
    if (const auto may = check_pass(change, kept_.points, state); !may) return may;
  for (const StateChange& change : changes) kept_.passes.push_back({change, ++last_pass_});
  const std::size_t most = BreakTable::kMostPasses;
  if (kept_.passes.size() > most)
    kept_.passes.erase(kept_.passes.begin(), kept_.passes.end() - most);
  publish();
  return {};
}

std::vector<BreakPoint> Breaks::points() const {
  const std::lock_guard lock(mutex_);
  return kept_.points;
}

std::optional<BreakPoint> Breaks::find(std::uint64_t number) const {
  const std::lock_guard lock(mutex_);
  for (const BreakPoint& point : kept_.points)
    if (point.number == number) return point;
  for (const BreakPoint& point : taken_off_)
    if (point.number == number) return point;
  return std::nullopt;
}

std::optional<BreakTable> Breaks::table(std::uint64_t number) const {
  const std::lock_guard lock(mutex_);
  const auto found = std::ranges::find(tables_, number, &BreakTable::number);
  return found == tables_.end() ? std::nullopt : std::optional(*found);
}

void Breaks::replay(BreakTable table) {
  const std::lock_guard lock(mutex_);
  kept_ = std::move(table);
  table_.publish(kept_);
}

void Breaks::publish() {
  ++kept_.number;
  tables_.push_back(kept_);
  if (tables_.size() > kTablesKept) tables_.pop_front();
  while (taken_off_.size() > kTakenOffKept) taken_off_.pop_front();
  table_.publish(kept_);
}

bool Breaks::is_locked(std::string_view from, std::string_view to) const noexcept {
  const BreakTable& table = table_.reading();
  const bool locked = std::ranges::any_of(table.points, [&](const BreakPoint& point) {
    return point.kind == BreakKind::kLock && point.at.matches(from, to);
  });
  return locked && std::ranges::none_of(table.passes, [&](const LockPass& pass) {
           return pass.number > ended_passes_ && pass.at.matches(from, to);
         });
}

const BreakPoint* Breaks::stop_at(std::string_view from, std::string_view to) const noexcept {
  const BreakPoint* found = nullptr;
  for (const BreakPoint& point : table_.reading().points) {
    if (point.kind == BreakKind::kLock || !point.at.matches(from, to)) continue;
    if (!found || (found->kind != BreakKind::kStopTeam && point.kind == BreakKind::kStopTeam))
      found = &point;
  }
  return found;
}

void Breaks::end_passes() noexcept {
  const auto& passes = table_.reading().passes;
  if (!passes.empty()) ended_passes_ = passes.back().number;
}

}  // namespace galilean::robot
