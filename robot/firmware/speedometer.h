// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace galilean::robot::firmware {

/// Measures speed from encoder counts: the travel over the last window of samples, divided by the
/// time of the window. The samples may come at uneven times. A longer window resolves finer (one
/// count in 20 ms is 50 counts/s), but delays the speed by half its length.
class Speedometer {
 public:
  /// Starts anew at `counts`, at rest. The first windows begin here.
  void reset(std::int32_t counts, std::uint32_t now_ms);
  /// Takes the next sample; counts and milliseconds may wrap around. Requires: `now_ms` is later
  /// than that of the sample before.
  void sample(std::int32_t counts, std::uint32_t now_ms);
  float speed_counts_s() const { return speed_; }
  /// Returns the speed over the newest samples that span kRecent_ms: coarser, but with less delay.
  /// One count in that time is 125 counts/s.
  float recent_speed_counts_s() const;
  /// Returns how fast the speed of the whole window changed with the last sample.
  float change_counts_s2() const { return change_; }

 private:
  static constexpr std::size_t kSamples = 10;
  static constexpr std::uint32_t kRecent_ms = 8;

  struct Sample {
    std::int32_t counts = 0;
    std::uint32_t time_ms = 0;
  };

  std::array<Sample, kSamples> samples_{};
  std::size_t oldest_ = 0;
  Sample newest_;
  std::uint32_t begin_ms_ = 0;  ///< of the window
  float speed_ = 0;
  float change_ = 0;
};

}  // namespace galilean::robot::firmware
