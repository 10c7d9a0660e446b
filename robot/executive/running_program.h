// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/variable/store.h"
#include "robot/executive/description.h"
#include "robot/executive/device_settings.h"
#include "robot/executive/schema_runner.h"

namespace galilean::robot {

/// A condition with its names looked up.
struct RunningCondition {
  Variable<Bits>* bits = nullptr;
  unsigned bit_index = 0;
  bool bit_value = true;
  bhdl::BitUpdate bit_update = bhdl::BitUpdate::kSame;
  std::uint32_t new_state = 0;
  std::vector<VariableRef> reset_variables;
};

/// A state with its names looked up. Schemas are indices into RunningProgram::schemas.
struct RunningState {
  std::vector<std::uint32_t> perceptual_schemas;
  std::vector<std::uint32_t> motor_schemas;
  std::vector<RunningCondition> conditions;
};

/// A program that is ready to run. The builder makes it, the tick runs it, a swap exchanges it.
/// Only the thread that holds it may touch it. Its description may be read by any thread.
struct RunningProgram {
  RunningProgram() = default;
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;

  [[nodiscard]] const bhdl::Program& text() const noexcept { return description->program; }
  [[nodiscard]] const std::string& state_name() const noexcept { return text().states[state].name; }

  std::shared_ptr<const Description> description;
  DeviceSettings devices;
  VariableStore variables;
  std::vector<Pose2> start_poses;  ///< of each shaft, as the text gives it
  std::vector<SchemaRunner> schemas;
  std::vector<RunningState> states;
  std::uint32_t start_state = 0;
  std::uint32_t state = 0;  ///< the current state; while another program runs, the state that it
                            ///< was left in
  Time state_since{};
};

/// Keeps all that a program remembers from one tick to the next.
void keep(RunningProgram& program, Memory& memory) noexcept;

}  // namespace galilean::robot
