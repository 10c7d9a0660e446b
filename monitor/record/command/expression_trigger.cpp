// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/command/expression_trigger.h"

#include <utility>

#include "core/visible_text.h"
#include "monitor/expect/language/parser.h"
#include "monitor/wire/topic_name.h"

namespace galilean::monitor {
namespace {

constexpr std::size_t kMostWays = 10'000;

}  // namespace

/// A condition that must never hold fails when it comes true.
Result<std::unique_ptr<ExpressionTrigger>> ExpressionTrigger::read(const std::string& text,
                                                                   Definitions& definitions) {
  const std::string quoted = "'" + visible(text) + "'";
  auto parsed = expect::parse("--on", "every robot: never " + text);
  if (!parsed.ok())
    return Error{quoted + " is no condition: " + parsed.diagnostics.front().message};
  const auto& all = parsed.expectations;
  if (all.size() != 1 || all.front().claims.size() != 1)
    return Error{quoted + " is more than one condition; connect them with 'or'"};
  return std::unique_ptr<ExpressionTrigger>(
      new ExpressionTrigger(std::move(parsed.expectations), definitions));
}

ExpressionTrigger::ExpressionTrigger(std::vector<expect::Expectation> expectations,
                                     Definitions& definitions)
    : expectations_(std::move(expectations)),
      definitions_(definitions),
      judge_(expectations_,
             {.on_failure =
                  [this](const expect::FailureNow& failure) {
                    if (event_) return;
                    event_ = visible(failure.robot) +
                             (failure.values.empty() ? "" : ": " + visible(failure.values));
                  }}),
      typed_(judge_) {}

void ExpressionTrigger::take(const wire::EndpointInfo& writer, const wire::Received& received,
                             Time at) {
  auto known = ways_.find(writer.guid);
  if (known == ways_.end()) {
    if (ways_.size() == kMostWays) ways_.clear();
    known = ways_.emplace(writer.guid, way_of(writer)).first;
  }
  const auto at_ns = static_cast<std::int64_t>((at - Time{}).count());
  const Way& way = known->second;
  if (way.typed) static_cast<void>((typed_.*way.typed)(at_ns, received.cdr));
  if (!way.fields) return;
  if (const auto fields = way.fields->decode(received.cdr))
    judge_.fields(at_ns, way.topic, fields.value());
}

/// Messages whose definition is not that of this release are none of those that conditions on
/// states, variables and scores ask about.
ExpressionTrigger::Way ExpressionTrigger::way_of(const wire::EndpointInfo& writer) {
  Way way{.topic = shown_topic(writer.topic)};
  const auto type = shown_type(writer.dds_type);
  const auto definition = definition_of(writer);
  const bool ours = definition == Definition::kOurs || definition == Definition::kUnpublished;
  if (ours && judge_.wants_type(type)) way.typed = expect::TypedDecoder::function_for(type);
  if (!judge_.wants_fields(way.topic)) return way;
  if (auto found = definitions_.find(writer)) way.fields.emplace(std::move(found).value());
  return way;
}

std::optional<std::string> ExpressionTrigger::happened() {
  return std::exchange(event_, std::nullopt);
}

}  // namespace galilean::monitor
