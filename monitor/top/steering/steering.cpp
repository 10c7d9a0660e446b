// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/steering/steering.h"

#include <utility>

#include "core/orders/stopping_orders.h"
#include "monitor/orders/break_words.h"

namespace galilean::monitor::top {
namespace {

constexpr Duration kTellAgainEach = std::chrono::seconds(1);
constexpr Duration kAllStoppedShown = std::chrono::seconds(5);

bool is_stop(Operator::Word word) noexcept {
  return word == Operator::Word::kHold || word == Operator::Word::kDecommission;
}

std::vector<std::string> names_of(const std::vector<Unconfirmed>& robots) {
  std::vector<std::string> names;
  for (const auto& each : robots) names.push_back(each.robot);
  return names;
}

}  // namespace

Steering::Steering(const DashboardModel& model, const Clock& clock, Voice voice,
                   NoticeBoard& notices)
    : model_(model), clock_(clock), voice_(std::move(voice)), notices_(notices) {}

void Steering::update() {
  if (auto told = answers_.take(model_.team(), clock_.now()); !told.empty())
    notices_.tell_of_now(std::move(told));
  if (stop_order_) tell_stop_again();
}

/// Requires: there is an order to stop.
void Steering::tell_stop_again() {
  const Time now = clock_.now();
  stop_order_->update(model_.team());
  const auto progress = stop_order_->progress(model_.team(), now);
  if (!progress.unconfirmed.empty()) all_stopped_.reset();
  if (progress.unconfirmed.empty() && !all_stopped_) all_stopped_ = now;
  if (all_stopped_ && now - *all_stopped_ > kAllStoppedShown) return stop_order_.reset();
  if (progress.unconfirmed.empty() || now - stop_told_ < kTellAgainEach) return;
  stop_told_ = now;
  static_cast<void>(voice_.say(Operator::Word::kHold, names_of(progress.unconfirmed)));
}

void Steering::stop_all() {
  const bool sent = !voice_.say(Operator::Word::kHold, {}).empty();
  stop_told_ = clock_.now();
  stop_order_.emplace(stop_told_);
  all_stopped_.reset();
  notices_.tell_of_now(sent ? "told all robots to stop; Esc ends the report"
                            : "DDS did not take the order to stop; it is sent again every second");
}

void Steering::say(Operator::Word word, const std::string& robot, bool to_all) {
  if (robot.empty()) return notices_.tell("No robot is heard that could be told.");
  if (!is_stop(word) && !may_steer_(robot, to_all)) return;
  if (word == Operator::Word::kResume) end_stop_of(robot, to_all);
  const std::string id =
      voice_.say(word, to_all ? std::vector<std::string>{} : std::vector<std::string>{robot});
  if (!id.empty()) expect_answers(word, id, to_all ? heard() : std::vector<std::string>{robot});
  notices_.tell_of_now((id.empty() ? "could not tell " : "told ") +
                       (to_all ? "all robots" : robot) + " to " + words_of(word));
}

/// Robots answer a step. Of other words they answer refusals alone, and they refuse none that stops
/// them.
void Steering::expect_answers(Operator::Word word, const std::string& id,
                              std::vector<std::string> robots) {
  if (word == Operator::Word::kStep)
    answers_.expect(id, "", std::move(robots), clock_.now());
  else if (!is_stop(word))
    answers_.expect_refusals(id, std::move(robots), clock_.now());
}

void Steering::order_breaks(const std::string& robot, const std::string& order,
                            std::vector<msg::BreakPoint> points) {
  msg::BreakOrder told;
  told.targets = {robot};
  told.order = order;
  told.points = std::move(points);
  if (!only_stops(told) && !may_steer_(robot, false)) return;
  const std::string id = voice_.order_breaks(told);
  if (id.empty()) return notices_.tell_of_now("could not tell " + robot + " about break points");
  answers_.expect(id, effect_of(told), {robot}, clock_.now());
  notices_.tell_of_now("told " + robot + " about break points");
}

std::vector<std::string> Steering::heard() const {
  std::vector<std::string> names;
  for (const auto& [name, robot] : model_.team().robots())
    if (!model_.team().silent(robot) && !model_.team().replayed(robot)) names.push_back(name);
  return names;
}

std::string Steering::stop_report() const {
  if (!stop_order_) return {};
  return "STOP ALL: " + stop_sentence(stop_order_->progress(model_.team(), clock_.now()));
}

void Steering::end_stop_of(const std::string& robot, bool of_all) {
  if (!stop_order_) return;
  stop_order_->release(robot);
  const auto rest = stop_order_->progress(model_.team(), clock_.now());
  if (of_all || (rest.stopped.empty() && rest.unconfirmed.empty())) stop_order_.reset();
}

}  // namespace galilean::monitor::top
