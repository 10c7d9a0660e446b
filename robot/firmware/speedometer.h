#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace galilean::robot::firmware {

/// Speed from encoder counts: what was travelled over the last window of samples. A longer window
/// resolves finer (one count in 20 ms is 50 counts/s) but tells it later, by half its length.
class Speedometer {
 public:
  /// Starts anew, standing at `counts`.
  void reset(std::int32_t counts);
  /// Takes the next sample, `dt_s` after the last; counts may wrap around.
  void sample(std::int32_t counts, float dt_s);
  float speed_counts_s() const { return speed_; }

 private:
  static constexpr std::size_t kSamples = 10;

  std::array<std::int32_t, kSamples> counts_{};
  std::size_t oldest_ = 0;
  float speed_ = 0;
};

}  // namespace galilean::robot::firmware
