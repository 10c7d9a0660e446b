#include "robot/firmware/speedometer.h"

namespace galilean::robot::firmware {

void Speedometer::reset(std::int32_t counts) {
  counts_.fill(counts);
  speed_ = 0;
}

void Speedometer::sample(std::int32_t counts, float dt_s) {
  const auto travelled =
      static_cast<std::uint32_t>(counts) - static_cast<std::uint32_t>(counts_[oldest_]);
  speed_ = static_cast<float>(static_cast<std::int32_t>(travelled)) / (kSamples * dt_s);
  counts_[oldest_] = counts;
  oldest_ = (oldest_ + 1) % kSamples;
}

}  // namespace galilean::robot::firmware
