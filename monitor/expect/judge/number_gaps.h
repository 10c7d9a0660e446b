// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "monitor/expect/judge/span_list.h"

namespace galilean::expect {

/// The number that a writer gave a message: it rises by one with each of its messages.
struct Numbered {
  std::uint64_t writer = 0;    ///< tells a topic's writers apart
  std::uint64_t sequence = 0;  ///< 0: unknown
};

/// Tells what is missing of a topic's messages by the numbers that each writer gave its own.
class NumberGaps {
 public:
  void note(std::int64_t at_ns, const Numbered& message);

  /// Returns how many are missing between those that came.
  [[nodiscard]] std::uint64_t missing() const noexcept { return missing_; }
  /// Returns when they are missing.
  [[nodiscard]] const SpanList& times() const noexcept { return times_; }
  /// Returns whether the numbers tell what is missing.
  [[nodiscard]] bool tells() const noexcept { return !unnumbered_ && !went_back_; }
  /// Returns why they do not; an empty text if they do.
  [[nodiscard]] std::string doubt() const;

 private:
  struct Newest {
    std::uint64_t sequence = 0;
    std::int64_t at_ns = 0;
  };

  std::map<std::uint64_t, Newest> newest_;  ///< by writer
  std::uint64_t missing_ = 0;
  SpanList times_;
  bool unnumbered_ = false, went_back_ = false;
};

}  // namespace galilean::expect
