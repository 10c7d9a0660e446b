// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/wire/messages.h"
#include "robot/executive/break_point.h"
#include "robot/executive/description.h"
#include "robot/inputs/inputs_tap.h"
#include "robot/inputs/picture_packing.h"

namespace galilean::robot {

/// Returns the outcome of a tick that ended in `state`.
[[nodiscard]] msg::TickOutcome outcome_on_wire(const TickOutcome& outcome, std::string state);

/// Makes messages of the ticks that a tap hands over. For use by the tap's reader.
class InputsComposer {
 public:
  struct Source {
    std::string robot;
    std::uint64_t seed = 1;
    /// Return nothing for what is not kept any more. The messages then lack it, and cannot be run
    /// again.
    std::function<std::shared_ptr<const Description>(ProgramId)> description;
    std::function<std::optional<BreakTable>(std::uint64_t)> break_table;
  };

  explicit InputsComposer(Source source) : source_(std::move(source)) {}

  /// Takes the oldest tick over. Returns false if there is none. Leaves `stamp` to the caller.
  /// Errors: throws std::runtime_error if the picture cannot be packed.
  [[nodiscard]] bool take(InputsTap& tap, msg::TickInputs& to);
  /// Forgets what messages before have told: the next one tells it again.
  void begin_anew() noexcept { told_table_ = 0; }

 private:
  void add_program(const TickRecord& record, msg::TickInputs& to);
  void add_breaks(const TickRecord& record, msg::TickInputs& to);
  void add_memory(const TickRecord& record, const InputsTap& tap, msg::TickInputs& to);
  void add_picture(const TickRecord& record, const InputsTap& tap, msg::TickInputs& to);
  [[nodiscard]] std::string state_name(const TickOutcome& outcome);

  Source source_;
  std::uint64_t told_table_ = 0;
  std::shared_ptr<const Description> program_;  ///< the one that ran in the newest tick
  std::uint64_t pixels_digest_ = 0;             ///< of the newest picture
  PicturePacker packer_;
};

}  // namespace galilean::robot
