// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace galilean::expect {

/// From one instant to another, both included. Times are nanoseconds since the Unix epoch.
struct Span {
  std::int64_t from_ns = 0, to_ns = 0;
  [[nodiscard]] bool overlaps(const Span& other) const noexcept {
    return from_ns <= other.to_ns && other.from_ns <= to_ns;
  }
};

/// All times.
inline constexpr Span kAnyTime{std::numeric_limits<std::int64_t>::min(),
                               std::numeric_limits<std::int64_t>::max()};

/// Returns the span without a limit on that side on which it reaches the limit of `all`. Where
/// messages are lost before the first that was heard, or behind the last, the true limits are
/// unknown.
[[nodiscard]] inline Span without_limits_of(const Span& all, Span span) noexcept {
  if (span.from_ns <= all.from_ns) span.from_ns = kAnyTime.from_ns;
  if (span.to_ns >= all.to_ns) span.to_ns = kAnyTime.to_ns;
  return span;
}

/// Returns the instants between the two limits of a span, at which themselves something was heard;
/// or the span if there are none.
[[nodiscard]] inline Span inside(const Span& span) noexcept {
  return span.to_ns - span.from_ns < 2 ? span : Span{span.from_ns + 1, span.to_ns - 1};
}

/// Spans of time in which something is not known. It takes bounded memory: once it is full, the
/// newest grows to cover what is added.
class SpanList {
 public:
  static constexpr std::size_t kMost = 64;

  void add(const Span& span) {
    const bool joins = !spans_.empty() && spans_.back().overlaps(span);
    if (!joins && spans_.size() < kMost) return spans_.push_back(span);
    Span& last = spans_.back();
    last = {std::min(last.from_ns, span.from_ns), std::max(last.to_ns, span.to_ns)};
  }
  [[nodiscard]] std::optional<Span> overlap(const Span& with) const {
    for (const auto& span : spans_)
      if (span.overlaps(with)) return span;
    return std::nullopt;
  }
  [[nodiscard]] bool empty() const noexcept { return spans_.empty(); }
  [[nodiscard]] const Span& first() const noexcept { return spans_.front(); }

 private:
  std::vector<Span> spans_;
};

}  // namespace galilean::expect
