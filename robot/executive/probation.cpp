#include "robot/executive/probation.h"

namespace galilean::robot {

void Probation::begin(Time now, Duration length, const DeviceHealth& health) noexcept {
  *this = Probation();
  active_ = true;
  end_ = now + length;
  healthy_before_ = health;
}

void Probation::fail(Fault fault) noexcept {
  if (fault_ == Fault::kNone) fault_ = fault;
}

void Probation::note_schema_failure(std::uint32_t schema, const ShortText& reason) noexcept {
  if (fault_ != Fault::kNone) return;
  fail(Fault::kSchemaThrew);
  schema_ = schema;
  reason_ = reason;
}

void Probation::note_transition(Time now) noexcept {
  transition_times_[transitions_++ % transition_times_.size()] = now;
  if (transitions_ < transition_times_.size()) return;
  const Time oldest = transition_times_[transitions_ % transition_times_.size()];
  if (now - oldest <= std::chrono::seconds(1)) fail(Fault::kThrashed);
}

void Probation::note_tick(const DeviceHealth& health, bool overran) noexcept {
  if (health.lost_since(healthy_before_)) fail(Fault::kDeviceLost);
  overruns_in_a_row_ = overran ? overruns_in_a_row_ + 1 : 0;
  if (overruns_in_a_row_ >= kOverrunsInARow) fail(Fault::kOverran);
}

}  // namespace galilean::robot
