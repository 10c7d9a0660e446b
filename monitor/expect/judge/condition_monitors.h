// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>

#include "monitor/expect/judge/monitor.h"

namespace galilean::expect {

/// The condition is true whenever it has a value, or with `wanted` false, never true. The margin is
/// the least of the condition's.
class AlwaysMonitor final : public Monitor {
 public:
  explicit AlwaysMonitor(bool wanted) : wanted_(wanted) {}

 private:
  void step(std::int64_t at_ns, const Value& first, const Value& second) override;
  void conclude(std::int64_t end_ns, Finding& finding) override;

  bool wanted_;
  bool was_wrong_ = false, had_value_ = false;
};

/// The condition is never true for so long. The margin is that time less the longest [s].
class NeverForMonitor final : public Monitor {
 public:
  explicit NeverForMonitor(double for_s) : for_ns_(to_ns(for_s)) {}
  [[nodiscard]] std::int64_t deadline() const override;

 private:
  void step(std::int64_t at_ns, const Value& first, const Value& second) override;
  void conclude(std::int64_t end_ns, Finding& finding) override;
  void measure(std::int64_t at_ns);

  std::int64_t for_ns_;
  std::optional<std::int64_t> since_ns_;
  bool told_ = false;  ///< the present run has failed already
};

/// The condition becomes true, within a time from the beginning, and for a time. The margin is the
/// time that was left [s], or without `within` the most of the condition's.
class EventuallyMonitor final : public Monitor {
 public:
  EventuallyMonitor(std::optional<double> within_s, std::optional<double> for_s)
      : within_ns_(within_s ? to_ns(*within_s) : kNever_ns), for_ns_(for_s ? to_ns(*for_s) : 0) {}
  [[nodiscard]] std::int64_t deadline() const override;

 private:
  void step(std::int64_t at_ns, const Value& first, const Value& second) override;
  void conclude(std::int64_t end_ns, Finding& finding) override;
  [[nodiscard]] bool limited() const noexcept { return within_ns_ != kNever_ns; }

  std::int64_t within_ns_, for_ns_;
  bool told_ = false;
  std::optional<std::int64_t> since_ns_, met_ns_;
};

/// Each time that the first condition comes true, the second is true at some time of the next so
/// many seconds. The margin is the least time that was left [s].
class AfterMonitor final : public Monitor {
 public:
  explicit AfterMonitor(double within_s) : within_ns_(to_ns(within_s)) {}
  [[nodiscard]] std::int64_t deadline() const override;

 private:
  /// Once so many wait for one response, more need not be kept: the response that comes in time
  /// for the last of these does for all later ones, and otherwise the claim fails anyway.
  static constexpr std::size_t kMostPending = 1024;

  void step(std::int64_t at_ns, const Value& first, const Value& second) override;
  void conclude(std::int64_t end_ns, Finding& finding) override;

  std::int64_t within_ns_;
  bool was_true_ = false;
  std::uint64_t triggers_ = 0;
  std::deque<std::int64_t> pending_ns_;
  std::optional<std::int64_t> late_since_ns_;  ///< the first that nothing has answered yet
};

/// The first condition is true until the second is, and that within a time from the beginning if
/// there is one. The margin is the time that was left, if there is one [s], else the least of the
/// first condition's.
class UntilMonitor final : public Monitor {
 public:
  explicit UntilMonitor(std::optional<double> within_s)
      : within_ns_(within_s ? to_ns(*within_s) : kNever_ns) {}
  [[nodiscard]] std::int64_t deadline() const override;

 private:
  void step(std::int64_t at_ns, const Value& first, const Value& second) override;
  void conclude(std::int64_t end_ns, Finding& finding) override;
  [[nodiscard]] bool limited() const noexcept { return within_ns_ != kNever_ns; }

  std::int64_t within_ns_;
  bool over_ = false;
  std::optional<std::int64_t> met_ns_;
};

/// The condition is true when the recording ends.
class AtEndMonitor final : public Monitor {
  void step(std::int64_t at_ns, const Value& first, const Value& second) override;
  void conclude(std::int64_t end_ns, Finding& finding) override;

  std::int64_t newest_ns_ = 0;
  Value newest_;
};

/// How often the condition comes true, in all or in any time of `window_s`. The margin is in times.
class CountMonitor final : public Monitor {
 public:
  CountMonitor(Operator op, double limit, std::optional<double> window_s)
      : op_(op), limit_(limit), window_ns_(window_s ? to_ns(*window_s) : 0) {}

 private:
  void step(std::int64_t at_ns, const Value& first, const Value& second) override;
  void conclude(std::int64_t end_ns, Finding& finding) override;
  void slide(std::int64_t at_ns);

  Operator op_;
  double limit_;
  std::int64_t window_ns_;
  bool was_true_ = false;
  std::uint64_t count_ = 0;
  std::int64_t newest_ns_ = 0;
  std::deque<std::int64_t> times_ns_;  ///< those in the window, at most kMostInWindow + 1
  std::size_t most_ = 0;               ///< in any window
};

}  // namespace galilean::expect
