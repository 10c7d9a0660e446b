// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/push.h"

#include <utility>

namespace galilean::monitor {

Push::Push(PushContent content, const OrderTargets& targets)
    : content_(std::move(content)),
      rollout_(content_.plan(targets)),
      steps_(content_.steps(!rollout_.rest().empty())) {
  steps_.begin_next();
}

Push::Push(PushOrder order, OrderTargets targets, PushIdentity identity)
    : Push(PushContent(std::move(order), std::move(identity)), targets) {
  requests_.push_back(content_.check(std::move(targets.awaited)));
}

Push Push::of_others(const msg::ProgramPush& message, const OrderTargets& targets, Time now) {
  Push push(PushContent(message), targets);
  push.is_answered_ = true;
  push.finish_step({}, now);
  Progress progress{.state = PushState::kForeign};
  const auto hash = push.record().hash;
  if (hash != message.hash)
    progress.steps = {{StepKind::kCheck, StepState::kFailed,
                       "it announces the hash " + message.hash + ", but its files have " +
                           (hash.empty() ? "none" : hash) + "; robots refuse it"}};
  push.requests_ = {RecordPush{message, std::move(progress)}};
  return push;
}

std::vector<PushRequest> Push::take_requests() {
  auto requests = std::exchange(requests_, {});
  if (!requests.empty() || told_changes_ == steps_.changes()) return requests;
  // The progress comes last, because a request before it may have failed at once.
  told_changes_ = steps_.changes();
  if (is_recording_asked_) requests.push_back(TellProgress{record()});
  return requests;
}

void Push::begin_next(Time now) {
  if (const Step* next = steps_.begin_next()) return begin(next->kind, now);
  answer(record());
}

void Push::begin(StepKind kind, Time now) {
  switch (kind) {
    case StepKind::kCheck:  // the constructor began it
      return;
    case StepKind::kTry:
      is_trial_under_way_ = true;
      return requests_.push_back(content_.trial(rollout_.plan().awaited));
    case StepKind::kCanary:
      rollout_.begin_canary(now);
      return send(content_.to_canary());
    case StepKind::kRest:
      rollout_.begin_rest(now);
      return send(content_.to_rest(rollout_.rest()));
  }
}

void Push::send(SendProgram program) {
  program.progress = progress();
  requests_.push_back(std::move(program));
}

void Push::finish_step(const std::string& detail, Time now) {
  steps_.finish(detail);
  begin_next(now);
}

void Push::end(StepState how, const std::string& detail) {
  if (is_over()) return;
  if (steps_.is_at(StepKind::kCanary) && rollout_.canary_may_run_it())
    requests_.push_back(content_.rollback(detail));
  if (std::exchange(is_trial_under_way_, false)) requests_.push_back(EndTrial{});
  // Replies are recorded as they come; whoever has sent none is known only now.
  for (const auto& reply : rollout_.replies())
    if (reply.status == ReplyStatus::kNoAnswer) requests_.push_back(RecordReply{reply});
  steps_.end(how, detail);
  answer(record());
}

void Push::take(const PushResult& result, Time now) {
  std::visit([&](const auto& each) { handle(each, now); }, result);
}

void Push::handle(const ProgramChecked& checked, Time /*now*/) {
  if (!checked.program) {
    is_refused_ = true;
    answer(broken(checked.program.error()));
    return fail("the program has errors");
  }
  content_.set_program(checked.program.value());
  if (is_over()) return;
  requests_.push_back(content_.recording(progress()));
  is_recording_asked_ = true;
}

void Push::handle(const PushRecorded& recorded, Time now) {
  if (!steps_.is_at(StepKind::kCheck)) return;
  if (!recorded.outcome) {
    const auto& why = recorded.outcome.error().message;
    answer(unavailable(why + "; nothing was pushed."));
    return fail(why);
  }
  finish_step(in_words(content_.taken()), now);
  const bool takes_long = order().trial.wanted || !order().canary.empty();
  if (takes_long) answer(record());
}

void Push::handle(const ProgramTried& tried, Time now) {
  if (!steps_.is_at(StepKind::kTry)) return;
  is_trial_under_way_ = false;
  if (!tried.figures) return fail(tried.figures.error().message);
  const auto& figures = tried.figures.value();
  trial_ = to_json(figures);
  const bool decides = !order().trial.only && !order().trial.even_if_worse;
  if (decides && clearly_worse(figures)) return fail("in simulation it " + in_words(figures));
  finish_step(in_words(figures), now);
}

void Push::handle(const SendFailed& /*failed*/, Time /*now*/) {
  answer(unavailable("DDS did not accept the program; try again."));
  fail("DDS did not accept the program; try again");
}

void Push::handle(const RequestFailed& failed, Time /*now*/) {
  answer(unavailable(failed.why + "."));
  fail(failed.why);
}

void Push::take_reply(const msg::ProgramReply& said, Time now) {
  if (!is_meant_by(said)) return;
  // A reply to the rollback order counts as one to this push, which the robot rolls back.
  auto reply = said;
  reply.id = id();
  const auto known = rollout_.note(reply, now);
  if (!known) return;
  requests_.push_back(RecordReply{*known});
  reply.robot == order().canary ? judge_canary(now) : judge_rest(now);
}

void Push::see_canary(bool silent, const std::string& running_hash, Time now) {
  if (steps_.is_at(StepKind::kCanary)) obey(rollout_.see_canary(silent, running_hash, now), now);
}

void Push::see_trial(std::size_t finished, std::size_t all) {
  if (steps_.is_at(StepKind::kTry))
    steps_.describe(std::to_string(finished) + " of " + std::to_string(all) + " runs are over");
}

void Push::obey(const Verdict& verdict, Time now) {
  switch (verdict.kind) {
    case Verdict::Kind::kPending:
      return;
    case Verdict::Kind::kUnderWay:
      return steps_.describe(verdict.detail);
    case Verdict::Kind::kDone:
      return finish_step(verdict.detail, now);
    case Verdict::Kind::kFailed:
      return fail(verdict.detail);
  }
}

Result<void, Refusal> Push::cancel(const std::string& who) {
  if (is_over() || rollout_.has_reached_all()) return too_late(record());
  end(StepState::kCancelled, "cancelled by " + who);
  return {};
}

}  // namespace galilean::monitor
