// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bit>
#include <cstdint>
#include <string_view>

#include "core/clock.h"
#include "core/geometry.h"

namespace galilean::robot {

/// A 64-bit FNV-1a hash. Equal hashes show that two runs went the same way.
class StateHash {
 public:
  void add(std::uint64_t number) noexcept {
    for (int byte = 0; byte < 8; ++byte) add_byte(static_cast<std::uint8_t>(number >> 8 * byte));
  }
  void add(double number) noexcept { add(std::bit_cast<std::uint64_t>(number)); }
  void add(const Vec2& vector) noexcept {
    add(vector.x());
    add(vector.y());
  }
  void add(std::string_view text) noexcept {
    for (const char c : text) add_byte(static_cast<std::uint8_t>(c));
    add_byte(0);
  }
  [[nodiscard]] std::uint64_t value() const noexcept { return value_; }

 private:
  void add_byte(std::uint8_t byte) noexcept { value_ = (value_ ^ byte) * 0x100000001b3; }

  std::uint64_t value_ = 0xcbf29ce484222325;
};

struct RunningProgram;

void add_pose(StateHash& hash, const Pose2& pose) noexcept;
/// Adds every variable with its certainty at `now`. Of an image it adds the number of its frame.
void add_variables(StateHash& hash, const RunningProgram& program, Time now) noexcept;

}  // namespace galilean::robot
