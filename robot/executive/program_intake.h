// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string_view>

#include "core/result.h"
#include "robot/executive/builder.h"
#include "robot/executive/exchange.h"

namespace galilean::robot {

/// An operator's order to replace a program by the one that ran before it.
struct RollbackOrder {
  ProgramId program = 0;
  ShortText reason;
};

/// The entrance of an executive for threads other than the control loop. They hand in programs and
/// orders, and the control loop takes these without waiting. They also find the description of each
/// program here. Every method says which side may call it.
class ProgramIntake {
 public:
  /// Any thread but control. Builds `program` under the next number and lets it wait for a tick.
  /// Errors: another one still waits; the program cannot be built.
  [[nodiscard]] Result<ProgramId> load(bhdl::Program program, const BuildMaterial& material);
  /// Any thread but control. Returns false if too many orders wait.
  [[nodiscard]] bool order_rollback(const RollbackOrder& order);
  /// Any thread but control: destroys programs that were replaced. `load` does so too.
  void collect();
  /// Any thread but control. Returns null for a program that no longer exists, if sixteen others
  /// came after it.
  [[nodiscard]] std::shared_ptr<const Description> description(ProgramId id) const;
  /// Any thread. Returns whether a program waits for its first tick.
  [[nodiscard]] bool waiting() const noexcept { return exchange_.waiting(); }

  /// Control: takes the program that waits. Returns null if none does.
  [[nodiscard]] std::unique_ptr<RunningProgram> take() noexcept { return exchange_.take(); }
  /// Control: takes the oldest order that waits.
  [[nodiscard]] std::optional<RollbackOrder> take_order() noexcept { return orders_.pop(); }
  /// Control: hands back a program that no longer runs. Another thread destroys it.
  void retire(std::unique_ptr<RunningProgram> program) noexcept {
    if (program) exchange_.retire(std::move(program));
  }

 private:
  void forget_old_descriptions();

  mutable std::mutex mutex_;  ///< guards what the control loop never touches
  std::map<ProgramId, std::shared_ptr<const Description>> descriptions_;
  ProgramId last_id_ = 0;
  Exchange exchange_;
  SpscRing<RollbackOrder, 4> orders_;  ///< written under mutex_
};

}  // namespace galilean::robot
