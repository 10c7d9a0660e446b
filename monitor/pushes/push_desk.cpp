// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/push_desk.h"

#include <algorithm>
#include <utility>

#include "core/wire/ros_time.h"
#include "core/wire/topic_names.h"
#include "monitor/pushes/json.h"
#include "monitor/pushes/push_words.h"

namespace galilean::monitor {
namespace {

/// Replies to older pushes (a late rollback) are no longer told apart.
constexpr std::size_t kMostOpen = 64;
constexpr auto kWatchEach = std::chrono::milliseconds(50);

SwapPlan plan_of(const PushOrder& order, const OrderTargets& targets) {
  return {.id = new_id(),
          .awaited = targets.names(),
          .silent = targets.silent,
          .tries = order.trial.wanted,
          .tries_only = order.trial.only,
          .canary = order.canary,
          .probation = order.probation.value_or(SwapPlan().probation)};
}

std::string runs_words(const Trial& trial) {
  return std::to_string(trial.finished_runs()) + " of " + std::to_string(trial.all_runs()) +
         " runs are over";
}

}  // namespace

PushDesk::PushDesk(const Parts& parts, wire::Participant& participant)
    : parts_(parts),
      pushes_(participant, wire::kProgramPushTopic),
      rollbacks_(participant, wire::kProgramRollbackTopic),
      progress_(participant, wire::kPushProgressTopic),
      timer_(parts.io) {
  watch();
}

PushDesk::OpenPtr PushDesk::find(const std::string& id) const {
  const auto found = std::ranges::find_if(open_, [&](auto& open) { return open->record.id == id; });
  return found == open_.end() ? nullptr : *found;
}

PushDesk::OpenPtr PushDesk::taken_back_by(const std::string& order_id) const {
  const auto found =
      std::ranges::find_if(open_, [&](auto& open) { return open->take_back_id == order_id; });
  return order_id.empty() || found == open_.end() ? nullptr : *found;
}

PushDesk::OpenPtr PushDesk::under_way_to(const std::vector<std::string>& targets) const {
  for (const auto& open : open_)
    if (open->is_ours && !open->swap.over() && overlap(open->record.targets, targets)) return open;
  return nullptr;
}

PushDesk::OpenPtr PushDesk::keep(OpenPush open) {
  open_.push_back(std::make_shared<OpenPush>(std::move(open)));
  const auto oldest_over =
      std::ranges::find_if(open_, [](auto& each) { return each->swap.over(); });
  if (open_.size() > kMostOpen && oldest_over != open_.end()) open_.erase(oldest_over);
  return open_.back();
}

void PushDesk::order(PushOrder order, Finish finish) {
  auto targets = targets_of(order, parts_.team);
  if (!targets.objection.empty()) return finish({targets.status, {}, targets.objection});
  if (const auto other = under_way_to(order.targets)) return finish(conflict(other->newest()));
  if (const auto other = stale(order, targets, parts_.team))
    return refuse_stale(order, *other, std::move(finish));
  auto plan = plan_of(order, targets);
  PushRecord record{.id = plan.id,
                    .pushed_ns = wire::wall_clock_ns(),
                    .author = order.author,
                    .program = order.files.front().path,
                    .hash = {},
                    .targets = order.targets,
                    .progress = {},
                    .answers = {}};
  go_on(keep({.record = std::move(record),
              .swap = {std::move(plan), parts_.clock.now()},
              .order = std::move(order),
              .targets = std::move(targets),
              .finish = std::move(finish)}));
}

void PushDesk::refuse_stale(const PushOrder& order, const Stale& stale, Finish finish) {
  parts_.worker.run(
      [this, hash = stale.hash] { return parts_.history.last_push_of(hash); },
      [replaces = order.replaces, stale, finish](const std::optional<PushRecord>& by) {
        finish(overtaken(replaces, stale, by));
      },
      unable(finish));
}

void PushDesk::cancel(const std::string& id, const std::string& who, Finish finish) {
  const auto open = find(id);
  if (!open) return finish({404, {}, "No push '" + id + "' is under way."});
  if (!open->is_ours || !open->swap.cancel(who))
    return finish({409, {{"pushed", to_json(open->newest())}}, too_late(open->newest())});
  go_on(open);
  finish({200, to_json(open->newest())});
}

void PushDesk::describe(const std::string& id, Finish finish) {
  if (const auto open = find(id)) return finish({200, to_json(open->newest())});
  parts_.worker.run([this, id] { return parts_.history.push(id); },
                    [id, finish](const std::optional<PushRecord>& record) {
                      if (!record) return finish({404, {}, "There was no push '" + id + "'."});
                      finish({200, to_json(*record)});
                    },
                    unable(finish));
}

/// After anything happened to it: does what it asks for, and tells what became of it.
void PushDesk::go_on(const OpenPtr& open) {
  const auto failure = guarded("a push", [&] {
    for (auto acts = open->swap.take_acts(); !acts.empty(); acts = open->swap.take_acts())
      for (const auto each : acts) act(open, each);
  });
  if (failure) return give_up(open, failure->message);
  tell(open);
  if (open->swap.over()) open->answer({200, to_json(open->newest())});
}

/// This machine cannot go on with it. A canary is still taken back.
void PushDesk::give_up(const OpenPtr& open, const std::string& why) {
  open->answer({503, {}, why + "."});
  const bool was_under_way = !open->swap.over();
  open->swap.fail(why);
  if (was_under_way) go_on(open);
}

void PushDesk::tell(const OpenPtr& open) {
  if (!open->is_ours || open->told_version == open->swap.version()) return;
  open->told_version = open->swap.version();
  const auto record = open->newest();
  if (record.hash.empty()) return;  // nobody knows of it yet
  parts_.worker.run([this, record, message = progress_message(record)] {
    (void)progress_.write(message);
    parts_.history.set_progress(record.id, record.progress);
  });
}

void PushDesk::watch() {
  for (const auto& open : std::deque(open_))
    if (!open->swap.over()) guarded("watching a push", [&] { look_after(open); });
  timer_.expires_after(kWatchEach);
  timer_.async_wait([this](boost::system::error_code error) {
    if (!error) watch();
  });
}

void PushDesk::look_after(const OpenPtr& open) {
  if (const Robot* canary = parts_.team.find(open->order.canary); canary && canary->state)
    open->swap.see(canary->name, parts_.team.silent(*canary), canary->state->program_hash,
                   parts_.clock.now());
  if (open->trial) open->swap.describe(runs_words(*open->trial));
  open->swap.update(parts_.clock.now());
  go_on(open);
}

void PushDesk::note(const msg::ProgramPush& push) {
  if (find(push.id)) return;
  PushOrder order{.files = {}, .targets = push.targets, .author = push.author};
  const auto targets = targets_of(order, parts_.team);
  if (push.targets.empty()) parts_.team.note_push(push.hash);
  SwapPlan plan{.id = push.id, .awaited = targets.names(), .silent = targets.silent};
  keep({.record = {.id = push.id,
                   .pushed_ns = wire::since_epoch_ns(push.stamp),
                   .author = push.author,
                   .program = push.files.empty() ? std::string() : push.files.front().path,
                   .hash = push.hash,
                   .targets = push.targets,
                   .progress = {},
                   .answers = {}},
        .swap = SwapTransaction::of_others(std::move(plan), parts_.clock.now()),
        .order = std::move(order),
        .is_ours = false});
  parts_.worker.run([this, push] { parts_.history.add(push, {.state = {}}); });
}

/// A robot that was ordered back answers for the push that it goes back from.
void PushDesk::note(const msg::ProgramReply& said) {
  auto open = find(said.id);
  msg::ProgramReply reply = said;
  if (!open && said.status == msg::ProgramReply_Constants::ROLLED_BACK) {
    open = taken_back_by(said.id);
    if (open) reply.id = open->record.id;
  }
  if (!open || !open->swap.note(reply, parts_.clock.now())) return;
  for (const auto& answer : open->swap.answers())
    if (answer.robot == reply.robot)
      parts_.worker.run([this, id = reply.id, answer] { parts_.history.add_answer(id, answer); });
  go_on(open);
}

}  // namespace galilean::monitor
