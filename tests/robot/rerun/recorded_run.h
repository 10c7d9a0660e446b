// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "robot/inputs/compose_inputs.h"
#include "robot/rerun/rerun.h"

namespace galilean::robot {

/// Keeps the inputs of every tick of an executive, as a robot publishes them.
class InputsRecorder final : public TickObserver {
 public:
  /// Requires: it is called before the first tick.
  void record(InputsComposer::Source source) { compose_.emplace(std::move(source)); }
  void on_event(const Event& event) noexcept override { tap_.on_event(event); }
  void on_tick(const TickView& view) noexcept override {
    if (memory_each > 0 && view.tick.number % memory_each == 0) tap_.want_memory();
    tap_.on_tick(view);
    while (compose_->take(tap_, ticks.emplace_back())) {
    }
    ticks.pop_back();
  }

  std::vector<msg::TickInputs> ticks;
  std::uint64_t memory_each = 0;  ///< ticks; 0: the executive's memory is not recorded

 private:
  InputsTap tap_;
  std::optional<InputsComposer> compose_;
};

inline RerunResult run_again(const std::vector<msg::TickInputs>& ticks, const Registry& components,
                             std::optional<bhdl::Program> other = {}) {
  Rerun rerun(components, std::move(other));
  for (const auto& tick : ticks) rerun.take(tick);
  return rerun.result();
}

}  // namespace galilean::robot
