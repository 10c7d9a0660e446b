// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/clock.h"
#include "core/cut_text.h"
#include "core/memory.h"
#include "robot/executive/holding.h"

namespace galilean::robot {

/// The number of a program among those that an executive was given: 1, 2, 3 …; 0: none.
using ProgramId = std::uint32_t;

/// Why a program was replaced by the one before it.
enum class Fault : std::uint8_t { kNone, kSchemaThrew, kOverran, kDeviceLost, kThrashed, kOrdered };

/// Which devices answer.
struct DeviceHealth {
  bool comm_port = false;
  bool motor_drive = false;
  bool frame_grabber = false;

  void keep(Memory& memory) noexcept {
    memory.keep(comm_port);
    memory.keep(motor_drive);
    memory.keep(frame_grabber);
  }
};

/// A short text that is stored without the heap. A longer text is cut where a character ends.
class ShortText {
 public:
  ShortText() = default;
  explicit ShortText(std::string_view text) noexcept
      : size_(static_cast<std::uint8_t>(
            cut_text(text, text_.size()).copy(text_.data(), text_.size()))) {}
  [[nodiscard]] std::string_view view() const noexcept { return {text_.data(), size_}; }
  void keep(Memory& memory) noexcept {
    for (char& letter : text_) memory.keep(letter);
    memory.keep(size_);
    size_ = std::min<std::uint8_t>(size_, text_.size());
  }

 private:
  std::array<char, 127> text_{};
  std::uint8_t size_ = 0;
};

/// The truth of a state's conditions before one of them fired: bit i is condition i.
struct ConditionSnapshot {
  static constexpr std::uint32_t kMost = 64;  ///< later conditions are left out

  std::uint64_t valid = 0;  ///< its variable is valid
  std::uint64_t holds = 0;
};

/// Something that happened in a tick. Names are indices into the description of its program, so
/// that the control loop hands over nothing that it owns.
struct Event {
  enum class Kind : std::uint8_t {
    kTransition,    ///< the current state changed
    kStarted,       ///< the first program runs
    kSwapped,       ///< `program` runs in place of `from_program`
    kConfirmed,     ///< the probation of `program` is over
    kRolledBack,    ///< `program`, which ran before, runs again in place of `from_program`
    kSchemaFailed,  ///< schema `schema` of `program` threw and is switched off
  };
  /// What changed the state.
  enum class Cause : std::uint8_t { kCondition, kSwap, kRollback };
  static constexpr std::uint32_t kNone = 0xffffffff;

  Kind kind = Kind::kTransition;
  Cause cause = Cause::kCondition;
  Fault fault = Fault::kNone;  ///< the reason of a rollback
  bool in_probation = false;   ///< after a rollback: `program` has not proven itself either
  ProgramId program = 0;       ///< the one that runs after it
  ProgramId from_program = 0;  ///< the one that ran before it
  Time time{};
  std::uint64_t tick = 0;
  std::uint64_t number = 0;         ///< of kTransition: 1, 2, 3 … since the robot started
  std::uint32_t from_state = 0;     ///< in from_program
  std::uint32_t to_state = 0;       ///< in program
  std::uint32_t condition = kNone;  ///< of from_state, where that is the cause
  ConditionSnapshot tested;         ///< of from_state, where a condition is the cause
  Hold stopped_by = Hold::kNone;    ///< of kTransition: it stopped the robot, at a break point or
                                    ///< at the end of a step
  std::uint64_t break_point = 0;    ///< the number of that break point
  std::uint32_t schema = kNone;     ///< of kSchemaFailed and of a rollback, among all schemas
  Duration tick_time{};             ///< of kStarted, kSwapped and kRolledBack: what that tick took
  ShortText text;  ///< what the schema threw, which device was lost, or the reason of the order
};

}  // namespace galilean::robot
