// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/swap_transaction.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

namespace galilean::monitor {
namespace {

std::string seconds_text(Duration duration) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.3g s", to_seconds(duration));
  return text.data();
}

std::string why_not(const PushAnswer& answer) {
  const std::string more = answer.reply.message.empty() ? "" : ": " + answer.reply.message;
  if (answer.status == "rejected") return answer.robot + " refused it" + more;
  if (answer.status == "rolled_back") return answer.robot + " went back" + more;
  return answer.robot + " has not answered";
}

}  // namespace

SwapTransaction::SwapTransaction(SwapPlan plan, Time now) : plan_(std::move(plan)) {
  steps_ = {{.name = "check"}, {.name = "try"}, {.name = "canary"}, {.name = "rest"}};
  if (!plan_.tries) steps_[1].state = "left_out";
  if (plan_.canary.empty() || plan_.tries_only) steps_[kCanaryStep].state = "left_out";
  if (plan_.tries_only || (!plan_.canary.empty() && rest().empty())) steps_[3].state = "left_out";
  begin_next(now);
}

SwapTransaction SwapTransaction::of_others(SwapPlan plan, Time now) {
  SwapTransaction transaction(std::move(plan), now);
  transaction.checked({}, now);
  transaction.acts_.clear();
  return transaction;
}

std::vector<SwapTransaction::Act> SwapTransaction::take_acts() {
  return std::exchange(acts_, {});
}

SwapStep* SwapTransaction::running_step() {
  const auto found = std::ranges::find(steps_, "running", &SwapStep::state);
  return found == steps_.end() ? nullptr : &*found;
}

bool SwapTransaction::is_at(std::string_view step) const {
  return std::ranges::any_of(steps_, [step](const SwapStep& each) {
    return each.name == step && each.state == "running";
  });
}

void SwapTransaction::begin_next(Time now) {
  const auto next = std::ranges::find(steps_, "waiting", &SwapStep::state);
  ++version_;
  if (next == steps_.end())
    state_ = "done";
  else
    begin(*next, now);
}

void SwapTransaction::begin(SwapStep& step, Time now) {
  step.state = "running";
  began_ = now;
  if (step.name == "check") return acts_.push_back(Act::kCheck);
  if (step.name == "try") return acts_.push_back(Act::kTry);
  if (step.name == "canary") {
    canary_push_.emplace(plan_.id, std::vector{plan_.canary}, now);
    return acts_.push_back(Act::kPushCanary);
  }
  auto awaited = plan_.awaited;
  std::erase(awaited, plan_.canary);
  rest_push_.emplace(plan_.id, std::move(awaited), now);
  for (const auto& robot : plan_.silent) rest_push_->list(robot);
  acts_.push_back(Act::kPushRest);
}

void SwapTransaction::finish_step(const std::string& detail, Time now) {
  SwapStep* step = running_step();
  step->state = "done";
  step->detail = detail;
  begin_next(now);
}

void SwapTransaction::end(const std::string& step_state, const std::string& state,
                          const std::string& detail) {
  if (over()) return;
  if (is_at("canary") && canary_may_run()) acts_.push_back(Act::kTakeBack);
  if (is_at("try")) acts_.push_back(Act::kEndTrial);
  if (SwapStep* step = running_step()) {
    step->state = step_state;
    step->detail = detail;
  }
  for (auto& step : steps_)
    if (step.state == "waiting") step.state = "left_out";
  state_ = state;
  ++version_;
}

bool SwapTransaction::canary_may_run() const {
  const auto status = canary_push_->answers().front().status;
  return status != "rejected" && status != "rolled_back";
}

void SwapTransaction::fail(const std::string& why) {
  end("failed", "failed", why);
}

void SwapTransaction::describe(const std::string& detail) {
  SwapStep* step = running_step();
  if (!step || step->detail == detail) return;
  step->detail = detail;
  ++version_;
}

void SwapTransaction::checked(const std::string& objection, Time now) {
  if (!is_at("check")) return;
  objection.empty() ? finish_step({}, now) : fail(objection);
}

void SwapTransaction::tried(const std::string& objection, const std::string& finding, Time now) {
  if (!is_at("try")) return;
  objection.empty() ? finish_step(finding, now) : fail(objection);
}

bool SwapTransaction::note(const msg::ProgramReply& reply, Time now) {
  const bool of_canary = canary_push_ && reply.robot == plan_.canary;
  auto& push = of_canary ? canary_push_ : rest_push_;
  if (!push || !push->note(reply, now)) return false;
  of_canary ? judge_canary(now) : judge_rest(now);
  return true;
}

void SwapTransaction::judge_canary(Time now) {
  if (!is_at("canary")) return;
  if (!canary_may_run()) return fail(why_not(canary_push_->answers().front()));
  const bool runs = canary_push_->taken_by_all();
  if (!runs && now - began_ >= kPatience)
    return fail(plan_.canary + " did not answer within " + seconds_text(kPatience));
  if (!runs) return;
  if (!canary_runs_since_) {
    canary_runs_since_ = now;
    running_step()->detail =
        plan_.canary + " runs it, on probation for " + seconds_text(plan_.probation);
    ++version_;
  }
  if (now - *canary_runs_since_ >= plan_.probation)
    finish_step(plan_.canary + " ran it for " + seconds_text(plan_.probation), now);
}

void SwapTransaction::judge_rest(Time now) {
  if (!is_at("rest")) return;
  if (rest_push_->taken_by_all()) return finish_step({}, now);
  if (rest_push_->complete() || now - began_ >= kPatience) fail(shortcomings());
}

std::string SwapTransaction::shortcomings() const {
  std::string text;
  for (const auto& answer : answers()) {
    if (answer.status == "running" || answer.status == "confirmed") continue;
    if (std::ranges::find(plan_.silent, answer.robot) != plan_.silent.end()) continue;
    text += (text.empty() ? "" : "; ") + why_not(answer);
  }
  return text;
}

void SwapTransaction::see(const std::string& robot, bool silent, const std::string& running_hash,
                          Time now) {
  if (robot != plan_.canary || !is_at("canary") || !canary_runs_since_) return;
  const std::string pushed = canary_push_->answers().front().reply.hash;
  // A state that was under way when the program was swapped still names the one before.
  const bool settled = now - *canary_runs_since_ >= kPatience / 2;
  if (silent)
    fail(robot + " fell silent on its probation");
  else if (settled && !pushed.empty() && running_hash != pushed)
    fail(robot + " runs another program now: " + running_hash.substr(0, 8));
}

void SwapTransaction::update(Time now) {
  judge_canary(now);
  judge_rest(now);
}

bool SwapTransaction::cancel(const std::string& who) {
  if (over() || rest_push_) return false;
  end("cancelled", "cancelled", "cancelled by " + who);
  return true;
}

std::vector<std::string> SwapTransaction::rest() const {
  auto robots = plan_.awaited;
  robots.insert(robots.end(), plan_.silent.begin(), plan_.silent.end());
  std::erase(robots, plan_.canary);
  return robots;
}

std::vector<PushAnswer> SwapTransaction::answers() const {
  std::vector<PushAnswer> all;
  for (const auto* push : {&canary_push_, &rest_push_}) {
    if (!*push) continue;
    const auto some = (*push)->answers();
    all.insert(all.end(), some.begin(), some.end());
  }
  std::ranges::sort(all, {}, &PushAnswer::robot);
  return all;
}

}  // namespace galilean::monitor
