// SPDX-License-Identifier: BSD-3-Clause
// What an executive and its program remember from one tick to the next.
#include "robot/executive/executive.h"

namespace galilean::robot {
namespace {

void keep_value(Memory& memory, Shaft& shaft) noexcept {
  memory.keep(shaft.pose);
  memory.keep(shaft.speed_mps);
  memory.keep(shaft.turn_rate_radps);
}
void keep_value(Memory& memory, Image& image) noexcept {
  memory.keep(image.frame);
  memory.keep(image.captured);
  memory.keep(std::span<std::uint8_t>(image.pixels));
}
void keep_sighting(Memory& memory, Sighting& sighting) noexcept {
  memory.keep(sighting.position_m);
  memory.keep(sighting.covariance_m2);
  memory.keep(sighting.range_m);
  memory.keep(sighting.azimuth_rad);
  memory.keep(sighting.left_px);
  memory.keep(sighting.top_px);
  memory.keep(sighting.right_px);
  memory.keep(sighting.bottom_px);
  memory.keep(sighting.area_px);
}
void keep_value(Memory& memory, Locate& locate) noexcept {
  memory.keep(locate.object);
  memory.keep(locate.position_m);
  memory.keep(locate.covariance_m2);
  memory.keep(locate.radius_m);
  memory.keep(locate.sightings, keep_sighting);
  memory.keep(locate.sightings_frame);
}
void keep_value(Memory& memory, Bits& bits) noexcept {
  memory.keep(bits.value);
}
void keep_value(Memory& memory, Force& force) noexcept {
  memory.keep(force.value);
}

template <class T>
void keep_variable(Memory& memory, Variable<T>& variable) noexcept {
  memory.keep(variable.reliability.valid);
  memory.keep(variable.reliability.certainty);
  memory.keep(variable.reliability.decay_per_s);
  memory.keep(variable.reliability.stamp);
  memory.keep(variable.written_tick);
  keep_value(memory, variable.value);
}

}  // namespace

void keep(RunningProgram& program, Memory& memory) noexcept {
  memory.keep(program.state);
  memory.keep(program.state_since);
  program.variables.for_each([&](auto& variable) { keep_variable(memory, variable); });
  for (SchemaRunner& schema : program.schemas) schema.keep(memory);
}

void Executive::keep(Memory& memory) noexcept {
  memory.keep(tick_.number);
  memory.keep(tick_.now);
  memory.keep(overruns_);
  memory.keep(transitions_);
  memory.keep(hold_);
  standstill_.keep(memory);
  health_.keep(memory);
  odometry_.keep(memory);
  drive_.keep(memory);
  breaks_.keep(memory);
  succession_.probation().keep(memory);
  robot::keep(*current_program(), memory);
}

/// What saves changes nothing.
std::size_t Executive::save(std::span<std::uint64_t> room) const noexcept {
  if (!program()) return 0;
  Memory memory = Memory::saving(room);
  const_cast<Executive*>(this)->keep(memory);
  return memory.fits() ? memory.words() : 0;
}

bool Executive::adopt(std::span<const std::uint64_t> saved) noexcept {
  if (!succession_.adopt()) return false;
  RunningProgram& program = *current_program();
  if (setup_.tuner) setup_.tuner->tune(program.devices);
  Memory memory = Memory::loading(saved);
  keep(memory);
  holding_.replay(hold_);
  if (program.state >= program.states.size()) program.state = program.start_state;
  where_.store({succession_.running_id(), program.state});
  return memory.fits() && memory.words() == saved.size();
}

}  // namespace galilean::robot
