// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/command/expression_trigger.h"

#include <utility>

#include "core/visible_text.h"
#include "monitor/expect/language/parser.h"

namespace galilean::monitor {

namespace {

/// A condition that must never hold fails when it comes true.
Result<std::vector<expect::Expectation>> expectations_of(const std::string& text) {
  const std::string quoted = "'" + visible(text) + "'";
  auto parsed = expect::parse("--on", "every robot: never " + text);
  if (!parsed.ok())
    return Error{quoted + " is no condition: " + parsed.diagnostics.front().message};
  const auto& all = parsed.expectations;
  if (all.size() != 1 || all.front().claims.size() != 1)
    return Error{quoted + " is more than one condition; connect them with 'or'"};
  return std::move(parsed.expectations);
}

}  // namespace

Result<void> ExpressionTrigger::check(const std::string& text) {
  if (const auto read = expectations_of(text); !read) return read.error();
  return {};
}

Result<std::unique_ptr<ExpressionTrigger>> ExpressionTrigger::read(const std::string& text,
                                                                   Definitions& definitions) {
  auto expectations = expectations_of(text);
  if (!expectations) return expectations.error();
  return std::unique_ptr<ExpressionTrigger>(
      new ExpressionTrigger(std::move(expectations).value(), definitions));
}

ExpressionTrigger::ExpressionTrigger(std::vector<expect::Expectation> expectations,
                                     Definitions& definitions)
    : expectations_(std::move(expectations)),
      judge_(expectations_,
             {.on_failure =
                  [this](const expect::FailureNow& failure) {
                    if (event_) return;
                    event_ = visible(failure.robot) +
                             (failure.values.empty() ? "" : ": " + visible(failure.values));
                  }}),
      decoders_(definitions, judge_) {}

bool ExpressionTrigger::wants(const wire::EndpointInfo& writer) const {
  return decoders_.wants(writer);
}

/// What cannot be decoded cannot come true.
void ExpressionTrigger::take(const wire::EndpointInfo& writer, const wire::Received& received,
                             Time at) {
  static_cast<void>(decoders_.take((at - Time{}).count(), writer, received));
}

std::optional<std::string> ExpressionTrigger::happened() {
  return std::exchange(event_, std::nullopt);
}

std::vector<std::string> ExpressionTrigger::doubts() {
  auto sentences = decoders_.take_notes();
  for (auto& each : judge_.unknown_names()) sentences.push_back("--on: " + each);
  return sentences;
}

}  // namespace galilean::monitor
