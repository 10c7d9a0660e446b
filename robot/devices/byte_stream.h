// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "core/clock.h"

namespace galilean::robot {

/// One end of a line that carries bytes both ways. Nothing here blocks. All calls from one thread.
class ByteStream {
 public:
  virtual ~ByteStream() = default;
  /// Takes bytes that came; the number taken, 0 when none wait or the line is lost.
  virtual std::size_t read(std::span<std::uint8_t> bytes) = 0;
  /// Hands bytes over; the number taken, 0 when the line is full or lost.
  virtual std::size_t write(std::span<const std::uint8_t> bytes) = 0;
  /// Opens what is closed, now and then, so that a lost line comes back. Call it often.
  virtual void maintain(Time now) = 0;
  [[nodiscard]] virtual bool is_open() const = 0;
  /// One sentence on why the line is not open and what to do; empty while it is.
  [[nodiscard]] virtual std::string problem() const = 0;
  /// What the line is called where a person looks for it: a device's path, say.
  [[nodiscard]] virtual const std::string& name() const = 0;
};

}  // namespace galilean::robot
