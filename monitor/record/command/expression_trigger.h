// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "monitor/expect/judge/judge.h"
#include "monitor/expect/live/writer_decoders.h"
#include "monitor/record/snapshots.h"
#include "monitor/wire/definitions.h"

namespace galilean::monitor {

/// Waits until a condition of the language of expectations comes true for a robot, such as `state
/// is "stuck" for 3 s`. For use by one thread.
class ExpressionTrigger final : public Trigger {
 public:
  /// Errors: the text is no condition; the error is a sentence.
  [[nodiscard]] static Result<void> check(const std::string& text);
  /// Requires: `definitions` outlives this.
  /// Errors: the text is no condition; the error is a sentence.
  [[nodiscard]] static Result<std::unique_ptr<ExpressionTrigger>> read(const std::string& text,
                                                                       Definitions& definitions);

  [[nodiscard]] bool wants(const wire::EndpointInfo& writer) const override;
  void take(const wire::EndpointInfo& writer, const wire::Received& received, Time at) override;
  [[nodiscard]] std::optional<std::string> happened() override;
  /// They are on names that a robot's program does not have, and on what cannot be decoded.
  [[nodiscard]] std::vector<std::string> doubts() override;

 private:
  ExpressionTrigger(std::vector<expect::Expectation> expectations, Definitions& definitions);

  const std::vector<expect::Expectation> expectations_;
  std::optional<std::string> event_;
  expect::Judge judge_;
  expect::WriterDecoders decoders_;
};

}  // namespace galilean::monitor
