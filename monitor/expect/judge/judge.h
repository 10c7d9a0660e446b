// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/clock.h"
#include "monitor/expect/judge/needs.h"
#include "monitor/expect/judge/robot_watch.h"
#include "monitor/expect/judge/samples.h"
#include "monitor/expect/judge/verdict.h"

namespace galilean::expect {

struct JudgeOptions {
  /// A robot's state and variables are unknown once nothing was heard of them for longer.
  Duration silence = std::chrono::seconds(2);
  /// Called whenever a claim about conditions fails, while samples are taken; may be left empty. A
  /// claim about `some robot` fails for each robot for which it does not hold.
  std::function<void(const FailureNow&)> on_failure = {};
};

/// Judges expectations, one sample at a time. Its memory is bounded by the expectations, by the
/// robots and by what the newest messages hold, and not by how long it listens. For one thread.
class Judge final : public SampleSink {
 public:
  /// Requires: `expectations` outlives this.
  explicit Judge(const std::vector<Expectation>& expectations, JudgeOptions options = {});
  ~Judge() override;

  [[nodiscard]] bool wants_messages(std::string_view topic) const override;
  [[nodiscard]] bool wants_fields(std::string_view topic) const override;
  [[nodiscard]] bool wants_type(std::string_view ros_type) const override;
  void message(std::int64_t at_ns, std::string_view topic, const Numbered& number) override;
  void fields(std::int64_t at_ns, std::string_view topic,
              const monitor::MessageTree& message) override;
  void sample(std::int64_t at_ns, const msg::RobotState& state) override;
  void sample(std::int64_t at_ns, const msg::Transition& transition) override;
  void sample(std::int64_t at_ns, const msg::Variables& variables) override;
  void sample(std::int64_t at_ns, const msg::Score& score) override;
  void sample(std::int64_t at_ns, const msg::Program& program) override;
  void missed(std::string_view topic, std::optional<std::uint64_t> messages) override;
  void damage(const Span& span, const std::string& why) override;

  /// Returns a sentence for each robot whose program lacks a name that a claim about it has, as far
  /// as is known now: "io's program has no state 'stuk'; did you mean 'stuck'?".
  [[nodiscard]] std::vector<std::string> unknown_names() const;

  /// Returns what came of the expectations between the two instants. Call it once, at the end.
  [[nodiscard]] Judgement finish(std::int64_t begin_ns, std::int64_t end_ns);

 private:
  /// Returns the time, or the one before it if time went back.
  std::int64_t in_order(std::int64_t at_ns) noexcept;
  /// Returns what watches a robot, or nullptr if there are too many of them.
  RobotWatch* watch(std::string_view robot);
  template <class Apply>
  void share(std::int64_t at_ns, unsigned source, const Apply& apply);

  const std::vector<Expectation>& expectations_;
  JudgeOptions options_;
  Needs needs_;
  TeamBelief team_belief_;
  RobotWatch team_;
  std::map<std::string, std::unique_ptr<RobotWatch>, std::less<>> robots_;
  std::int64_t now_ns_ = 0;
  std::uint64_t late_ = 0;     ///< messages that were older than those before
  std::uint64_t refused_ = 0;  ///< messages of robots beyond the most
  SpanList damage_;
  std::vector<std::string> notes_;
};

}  // namespace galilean::expect
