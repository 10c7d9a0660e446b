// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "monitor/expect/judge/judge.h"
#include "monitor/expect/recording/typed_decoder.h"
#include "monitor/record/snapshots.h"
#include "monitor/wire/definitions.h"

namespace galilean::monitor {

/// Waits until a condition of the language of expectations comes true for a robot, such as `state
/// is "stuck" for 3 s`. For use by one thread.
class ExpressionTrigger final : public Trigger {
 public:
  /// Requires: `definitions` outlives this.
  /// Errors: the text is no condition; the error is a sentence.
  [[nodiscard]] static Result<std::unique_ptr<ExpressionTrigger>> read(const std::string& text,
                                                                       Definitions& definitions);

  void take(const wire::EndpointInfo& writer, const wire::Received& received, Time at) override;
  [[nodiscard]] std::optional<std::string> happened() override;

 private:
  /// How the messages of one writer are given to the judge.
  struct Way {
    std::string topic;
    expect::TypedDecoder::Decode typed = nullptr;
    std::optional<MessageDecoder> fields;
  };

  ExpressionTrigger(std::vector<expect::Expectation> expectations, Definitions& definitions);
  [[nodiscard]] Way way_of(const wire::EndpointInfo& writer);

  const std::vector<expect::Expectation> expectations_;
  Definitions& definitions_;
  std::optional<std::string> event_;
  expect::Judge judge_;
  expect::TypedDecoder typed_;
  std::map<std::string, Way> ways_;  ///< by the writer's GUID
};

}  // namespace galilean::monitor
