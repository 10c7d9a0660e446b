// SPDX-License-Identifier: BSD-3-Clause
#include "robot/executive/schema_runner.h"

#include <exception>
#include <utility>

namespace galilean::robot {

SchemaRunner::SchemaRunner(std::unique_ptr<Schema> schema, std::vector<VariableRef> outputs,
                           double gain)
    : schema_(std::move(schema)), outputs_(std::move(outputs)), gain_(gain) {
  if (gain_ == 1) return;
  for (const VariableRef& output : outputs_)
    if (auto* const* force = std::get_if<Variable<Force>*>(&output)) weighted_.push_back({*force});
}

template <class Call>
bool SchemaRunner::guarded(Call&& call, const Tick& tick) noexcept {
  if (failed_) return true;
  try {
    call();
    return true;
  } catch (const std::exception& problem) {
    fail(problem.what(), tick.now);
  } catch (...) {
    fail("something that is no std::exception", tick.now);
  }
  return false;
}

bool SchemaRunner::activate(const Tick& tick) noexcept {
  return guarded([&] { schema_->activate(tick); }, tick);
}

bool SchemaRunner::run(const Tick& tick) noexcept {
  return guarded(
      [&] {
        weighted_.empty() ? schema_->run(tick) : run_weighted(tick);
        last_run_ = tick.number;
      },
      tick);
}

/// Only forces that this schema writes in this run are multiplied. A force that another schema
/// wrote earlier in this tick stays as it is.
void SchemaRunner::run_weighted(const Tick& tick) {
  for (Weighted& each : weighted_) each.written_before = std::exchange(each.force->written_tick, 0);
  schema_->run(tick);
  for (const Weighted& each : weighted_)
    if (each.force->written_tick == tick.number)
      each.force->value.value *= gain_;
    else
      each.force->written_tick = each.written_before;
}

void SchemaRunner::keep(Memory& memory) noexcept {
  memory.keep(failed_);
  if (failed_) failure_.keep(memory);
  memory.keep(last_run_);
  schema_->keep(memory);
}

void SchemaRunner::fail(std::string_view reason, Time now) noexcept {
  failed_ = true;
  failure_ = ShortText(reason);
  for (const VariableRef& output : outputs_) reset(output, now);
}

}  // namespace galilean::robot
