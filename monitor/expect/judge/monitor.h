// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <string>

#include "monitor/expect/judge/finding.h"
#include "monitor/expect/judge/truth.h"
#include "monitor/expect/language/expectation.h"

namespace galilean::expect {

inline constexpr std::int64_t kNever_ns = std::numeric_limits<std::int64_t>::max();

/// Returns a time in nanoseconds.
[[nodiscard]] constexpr std::int64_t to_ns(double seconds) noexcept {
  return static_cast<std::int64_t>(seconds * 1e9);
}

/// Watches one claim for one robot, online: it gets the truth of the claim's conditions at each
/// instant at which they may change, and holds it to be the same until the next. Its memory is
/// bounded. The first instant at which all is known is its beginning.
class Monitor {
 public:
  virtual ~Monitor() = default;

  /// Returns what was so at that instant, in words.
  std::function<std::string()> describe;

  /// Called with the instant and what was so then, whenever the claim fails; may be left empty.
  std::function<void(std::int64_t at_ns, const std::string& values)> on_failure;

  /// Takes what holds from `at_ns` on. `second` is the response or the end, if the claim has one.
  /// Requires: times do not fall.
  void observe(std::int64_t at_ns, const Value& first, const Value& second = Value::of(true));
  /// Returns the instant at which it must be observed even if nothing changes; or kNever_ns.
  [[nodiscard]] virtual std::int64_t deadline() const { return kNever_ns; }
  /// Returns what it found until `end_ns`. Call it once, after the last observation.
  [[nodiscard]] Finding finish(std::int64_t end_ns);

 protected:
  /// Takes values, none of which is missing where the monitor began.
  virtual void step(std::int64_t at_ns, const Value& first, const Value& second) = 0;
  /// Sets the outcome, and the reason or the note. `fails` and `missing` are taken into account
  /// already where the outcome is kHolds.
  virtual void conclude(std::int64_t end_ns, Finding& finding) = 0;

  void fail(std::int64_t at_ns, std::optional<Span> needs = {});
  void keep_least(double margin) noexcept;
  void keep_most(double margin) noexcept;
  void set_margin(double margin) noexcept { finding_.margin = margin; }
  [[nodiscard]] std::int64_t begin_ns() const noexcept { return begin_ns_; }
  [[nodiscard]] const SpanList& missing() const noexcept { return missing_; }
  [[nodiscard]] bool failed() const noexcept { return finding_.failures > 0; }

 private:
  bool begun_ = false, was_missing_ = false;
  std::int64_t begin_ns_ = 0, last_ns_ = 0;
  SpanList missing_;
  std::uint64_t doubtful_ = 0;  ///< failures of a time in which something is missing
  Finding finding_;
};

/// Returns the monitor of a claim about conditions, or nullptr if the claim is about a topic alone.
[[nodiscard]] std::unique_ptr<Monitor> make_monitor(const Claim& claim);

}  // namespace galilean::expect
