// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "core/clock.h"

namespace galilean::robot {

/// One end of a line that carries bytes in both directions. No method blocks. Requires: all calls
/// come from one thread.
class ByteStream {
 public:
  virtual ~ByteStream() = default;
  /// Reads bytes that arrived. Returns how many. That is 0 when none wait or the line is lost.
  virtual std::size_t read(std::span<std::uint8_t> bytes) = 0;
  /// Writes bytes. Returns how many the line took. That is 0 when it is full or lost.
  virtual std::size_t write(std::span<const std::uint8_t> bytes) = 0;
  /// Tries from time to time to open a closed line, so that a lost line comes back. Requires: it is
  /// called often.
  virtual void maintain(Time now) = 0;
  [[nodiscard]] virtual bool is_open() const = 0;
  /// Returns one sentence on why the line is not open and what to do, or an empty text while it is
  /// open.
  [[nodiscard]] virtual std::string problem() const = 0;
  /// Returns the name by which a person finds the line, such as the path of a device.
  [[nodiscard]] virtual const std::string& name() const = 0;
};

}  // namespace galilean::robot
