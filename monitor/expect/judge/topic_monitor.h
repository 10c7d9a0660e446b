// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "monitor/expect/judge/finding.h"
#include "monitor/expect/judge/number_gaps.h"

namespace galilean::expect {

/// Watches when one topic's messages come.
class TopicMonitor {
 public:
  virtual ~TopicMonitor() = default;
  void message(std::int64_t at_ns, const Numbered& number);
  /// Takes how many messages the recorder counted as missing; nothing: it could not count them.
  void missed(std::optional<std::uint64_t> messages);
  /// Returns whether anything came.
  [[nodiscard]] bool any() const noexcept { return count_ > 0; }
  /// Returns what it found until `end_ns`. Call it once, after the last message.
  [[nodiscard]] Finding finish(std::int64_t end_ns);

 protected:
  virtual void step(std::int64_t at_ns) = 0;
  virtual void conclude(std::int64_t end_ns, Finding& finding) = 0;
  void fail(std::int64_t at_ns, std::string values, std::optional<Span> needs = {});
  void cannot_tell(std::string reason);
  /// Returns how many messages are missing, as far as that is known.
  [[nodiscard]] std::uint64_t missing() const noexcept;
  /// Returns why it is not known how many are missing; an empty text if it is.
  [[nodiscard]] std::string doubt() const;
  [[nodiscard]] std::string missing_text() const;
  /// Doubts what rests on times in which messages are missing. Call it last in `conclude`.
  void doubt_times();
  [[nodiscard]] const NumberGaps& gaps() const noexcept { return gaps_; }

  std::uint64_t count_ = 0;
  std::int64_t first_ns_ = 0, newest_ns_ = 0;  ///< `newest_ns_` is the one before, in a step
  Finding finding_;

 private:
  NumberGaps gaps_;
  bool was_counted_ = false;              ///< the recorder said how many it missed
  std::optional<std::uint64_t> counted_;  ///< nothing: it could not count them
};

}  // namespace galilean::expect
