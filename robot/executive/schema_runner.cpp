#include "robot/executive/schema_runner.h"

#include <exception>
#include <utility>

namespace galilean::robot {

SchemaRunner::SchemaRunner(std::unique_ptr<Schema> schema, std::vector<VariableRef> outputs)
    : schema_(std::move(schema)), outputs_(std::move(outputs)) {}

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
        schema_->run(tick);
        last_run_ = tick.number;
      },
      tick);
}

void SchemaRunner::fail(std::string_view reason, Time now) noexcept {
  failed_ = true;
  failure_ = ShortText(reason);
  for (const VariableRef& output : outputs_) reset(output, now);
}

}  // namespace galilean::robot
