// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <set>

#include "monitor/expect/judge/claim_watch.h"
#include "monitor/expect/judge/missed_states.h"
#include "monitor/expect/judge/topic_monitors.h"

namespace galilean::expect {

/// A claim about conditions that fails, when it does.
struct FailureNow {
  const Claim& claim;
  const std::string& robot;  ///< empty: the team
  std::int64_t at_ns;
  const std::string& values;  ///< what was so then
};

/// All claims about one robot, or about the team, and what is known of it.
class RobotWatch {
 public:
  using OnFailure = std::function<void(const FailureNow&)>;

  /// `robot` is empty for the team. Requires: `team` and `on_failure`, which may be empty, outlive
  /// this.
  RobotWatch(const std::string& robot, const TeamBelief& team, std::int64_t silence_ns,
             const OnFailure& on_failure);
  RobotWatch(const RobotWatch&) = delete;
  RobotWatch& operator=(const RobotWatch&) = delete;

  /// Adds a claim. Requires: it outlives this. `finish` returns what came of it.
  void add(const Claim& claim);

  void sample(std::int64_t at_ns, const msg::RobotState& state);
  void sample(std::int64_t at_ns, const msg::Transition& transition);
  void sample(std::int64_t at_ns, const msg::Variables& variables);
  void sample(const msg::Program& program);
  void message(std::int64_t at_ns, std::string_view topic, const Numbered& number);
  void missed(std::string_view topic, std::optional<std::uint64_t> messages);
  /// What all share changes: `advance` before it does, `observe` after it did.
  void advance(std::int64_t at_ns, unsigned sources);
  void observe(std::int64_t at_ns, unsigned sources);

  [[nodiscard]] bool heard() const noexcept { return belief_.state.message.has_value(); }
  /// Returns a sentence on the first name in its claims that its program does not have, as far as
  /// that is known; or an empty text.
  [[nodiscard]] std::string unknown_names() const;
  /// Returns what came of each claim, in the order in which they were added. Call it once.
  /// `heard_robots` are those of the team, of which one may have been meant.
  [[nodiscard]] std::vector<Finding> finish(std::int64_t end_ns,
                                            const std::set<std::string>& heard_robots);

 private:
  struct Entry {
    const Claim* claim;
    std::unique_ptr<ClaimWatch> conditions;  ///< one of the two
    std::unique_ptr<TopicMonitor> topic;
    std::string topic_name;
  };

  void begin(const msg::RobotState& state);
  void restart();
  void note_number(std::int64_t at_ns, std::uint64_t transition);
  void deliver(std::int64_t at_ns, const msg::Transition& transition);
  void show(std::int64_t at_ns, const msg::Transition& transition);
  [[nodiscard]] bool happened_before(const msg::Transition& transition) const;
  [[nodiscard]] std::uint64_t lost_transitions() const noexcept;
  [[nodiscard]] std::string complaint_on_names(const Claim& claim) const;
  void settle(const Claim& claim, const std::set<std::string>& heard_robots,
              Finding& finding) const;

  const OnFailure& on_failure_;
  Belief belief_;
  std::vector<Entry> entries_;
  std::deque<msg::Transition> waiting_;  ///< that came before the first state
  std::int64_t first_stamp_ns_ = 0;      ///< of the first state, by the robot's clock
  std::uint64_t first_number_ = 0, delivered_ = 0, lost_ = 0, newest_tick_ = 0;
  MissedStates missed_states_;
  std::int64_t numbered_ns_ = 0;  ///< when `belief_.transitions` was told, or told again
  std::set<std::string> states_, variables_;  ///< that its programs have
};

}  // namespace galilean::expect
