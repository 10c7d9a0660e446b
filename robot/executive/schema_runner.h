// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/schema/schema.h"
#include "robot/executive/event.h"
#include "robot/executive/variable_ref.h"

namespace galilean::robot {

/// Runs one schema of a program. If the schema throws, it is switched off for as long as the
/// program lives. The variables that it writes become invalid, so that no schema uses a
/// half-written value. Each force that it writes is multiplied by its gain.
class SchemaRunner {
 public:
  SchemaRunner(std::unique_ptr<Schema> schema, std::vector<VariableRef> outputs, double gain = 1);

  /// Return false only in the tick in which the schema throws.
  bool activate(const Tick& tick) noexcept;
  bool run(const Tick& tick) noexcept;

  [[nodiscard]] bool failed() const noexcept { return failed_; }
  /// Returns the message of the exception that the schema threw.
  [[nodiscard]] const ShortText& failure() const noexcept { return failure_; }
  /// Keeps what the schema remembers, and whether it failed.
  void keep(Memory& memory) noexcept;
  /// Returns the variables that the schema writes.
  [[nodiscard]] const std::vector<VariableRef>& outputs() const noexcept { return outputs_; }
  /// Returns the number of the tick in which the schema last ran, or 0 if it never did.
  [[nodiscard]] std::uint64_t last_run() const noexcept { return last_run_; }

 private:
  struct Weighted {
    Variable<Force>* force = nullptr;
    std::uint64_t written_before = 0;
  };

  template <class Call>
  bool guarded(Call&& call, const Tick& tick) noexcept;
  void fail(std::string_view reason, Time now) noexcept;
  void run_weighted(const Tick& tick);

  std::unique_ptr<Schema> schema_;
  std::vector<VariableRef> outputs_;
  double gain_;
  std::vector<Weighted> weighted_;  ///< the forces that it writes; none if the gain is 1
  ShortText failure_;
  std::uint64_t last_run_ = 0;
  bool failed_ = false;
};

}  // namespace galilean::robot
