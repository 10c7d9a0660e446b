// SPDX-License-Identifier: BSD-3-Clause
#include "robot/inputs/input_digests.h"

#include "robot/inputs/bit_digest.h"

namespace galilean::robot {
namespace {

void add(BitDigest& digest, const msg::BreakTable& table) {
  digest.add(table.number);
  for (const auto& point : table.points) {
    digest.add(point.from_state);
    digest.add(point.to_state);
    digest.add(point.kind);
  }
  for (const auto number : table.point_numbers) digest.add(number);
  for (const auto& pass : table.passes) {
    digest.add(pass.from_state);
    digest.add(pass.to_state);
    digest.add(pass.number);
  }
}

void add(BitDigest& digest, const msg::GivenProgram& program) {
  digest.add(program.id);
  digest.add(program.hash);
  for (const auto& file : program.files) {
    digest.add(file.path);
    digest.add(file.text);
  }
  digest.add(program.probation_ns);
  digest.add(program.most_transitions_per_s);
}

}  // namespace

std::uint64_t orders_digest(const msg::TickInputs& inputs) {
  BitDigest digest;
  digest.add(inputs.seed);
  digest.add(inputs.tick_period_ns);
  digest.add(inputs.tick);
  digest.add(inputs.now_ns);
  digest.add(inputs.tick_time_ns);
  digest.add(inputs.hold);
  digest.add(inputs.hold_changed);
  digest.add(inputs.in_service);
  for (const auto& table : inputs.break_table) add(digest, table);
  for (const auto& program : inputs.program) add(digest, program);
  digest.add(inputs.rolled_back);
  digest.add(inputs.rollback_reason);
  return digest.value();
}

std::uint64_t board_digest(const msg::TickInputs& inputs) {
  BitDigest digest;
  for (const bool each : {inputs.comm_port, inputs.motor_drive, inputs.frame_grabber,
                          inputs.beam_broken, inputs.gripper_closed})
    digest.add(each);
  digest.add(inputs.received_ns);
  digest.add(inputs.bumpers);
  for (const double each :
       {inputs.left_travel_m, inputs.right_travel_m, inputs.left_speed_mps, inputs.right_speed_mps})
    digest.add(each);
  digest.add(inputs.epoch);
  return digest.value();
}

std::uint64_t memory_digest(const msg::ExecutiveMemory& memory,
                            std::span<const std::uint64_t> words) {
  BitDigest digest;
  add(digest, memory.program);
  add(digest, memory.break_table);
  digest.add(memory.has_predecessor);
  for (const std::uint64_t word : words) digest.add(word);
  return digest.value();
}

std::uint64_t pixels_digest(std::span<const std::uint8_t> rgb) {
  BitDigest digest;
  digest.add(rgb);
  return digest.value();
}

std::uint64_t picture_digest(const msg::TickInputs& inputs, std::uint64_t pixels) {
  BitDigest digest;
  digest.add(inputs.frame);
  digest.add(inputs.captured_ns);
  digest.add(pixels);
  return digest.value();
}

}  // namespace galilean::robot
