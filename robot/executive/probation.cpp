#include "robot/executive/probation.h"

namespace galilean::robot {

void Probation::begin(Time now, Duration length, const DeviceHealth& health) noexcept {
  *this = Probation();
  active_ = true;
  end_ = now + length;
  healthy_before_ = health;
}

void Probation::fail(Fault fault, std::string_view detail) noexcept {
  if (fault_ != Fault::kNone) return;
  fault_ = fault;
  reason_ = ShortText(detail);
}

void Probation::note_schema_failure(std::uint32_t schema, const ShortText& reason) noexcept {
  if (fault_ == Fault::kNone) schema_ = schema;
  fail(Fault::kSchemaThrew, reason.view());
}

void Probation::note_transition(Time now) noexcept {
  transition_times_[transitions_++ % transition_times_.size()] = now;
  if (transitions_ < transition_times_.size()) return;
  const Time oldest = transition_times_[transitions_ % transition_times_.size()];
  if (now - oldest <= std::chrono::seconds(1)) fail(Fault::kThrashed);
}

void Probation::note_health(const DeviceHealth& health) noexcept {
  const DeviceHealth& before = healthy_before_;
  if (before.comm_port && !health.comm_port) fail(Fault::kDeviceLost, "comm_port");
  if (before.motor_drive && !health.motor_drive) fail(Fault::kDeviceLost, "motor_drive");
  if (before.frame_grabber && !health.frame_grabber) fail(Fault::kDeviceLost, "frame_grabber");
}

void Probation::note_tick(const DeviceHealth& health, bool overran) noexcept {
  note_health(health);
  overruns_in_a_row_ = overran ? overruns_in_a_row_ + 1 : 0;
  if (overruns_in_a_row_ >= kOverrunsInARow) fail(Fault::kOverran);
}

}  // namespace galilean::robot
