// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "core/clock.h"
#include "core/memory.h"

namespace galilean {

/// One turn of the control loop.
struct Tick {
  Time now{};
  Duration period{};
  std::uint64_t number = 0;  ///< 1, 2, 3 … since the robot started
};

/// The unit of execution. Instances are made when a program is built. `describe` declares what they
/// read, write and are set to (see core/catalog/declaration.h). `run` neither allocates, locks nor
/// does I/O. A schema that throws is switched off and reported; the others run on.
class Schema {
 public:
  virtual ~Schema() = default;
  /// Is called when the program enters a state that lists this schema. For example, a timer starts
  /// here.
  virtual void activate(const Tick&) {}
  virtual void run(const Tick& tick) = 0;
  /// Keeps what the schema remembers from one run to the next, but for variables and settings. A
  /// run that is run again from its middle goes on from there.
  virtual void keep(Memory&) noexcept {}
};

/// A schema that reads devices and variables, and writes what it perceived into variables.
class PerceptualSchema : public Schema {};

/// A schema that suggests a motion or commands a device.
class MotorSchema : public Schema {};

}  // namespace galilean
