// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/push_desk.h"

#include <algorithm>
#include <utility>

#include "core/wire/ros_time.h"
#include "core/wire/topic_names.h"
#include "monitor/background/guarded.h"
#include "monitor/pushes/history/push_messages.h"

namespace galilean::monitor {
namespace {

/// The number of pushes that are kept, unless more are under way. Late replies to older pushes,
/// such as rollbacks, are ignored.
constexpr std::size_t kMostOpen = 64;
constexpr auto kWatchEach = std::chrono::milliseconds(50);

/// Returns the push with this machine's time, if its sender's clock is ahead. The time is for
/// people: the order of pushes is that in which they come.
msg::ProgramPush not_of_the_future(msg::ProgramPush push) {
  const std::int64_t now_ns = wire::wall_clock_ns();
  if (wire::since_epoch_ns(push.stamp) > now_ns) push.stamp = wire::ros_time(now_ns);
  return push;
}

}  // namespace

PushDesk::PushDesk(const PushExecutor::Parts& parts, const Clock& clock,
                   wire::Participant& participant)
    : parts_(parts),
      clock_(clock),
      refusals_(participant.refusals()),
      executor_(parts, participant,
                [this](const std::string& id, const PushResult& result) { take(id, result); }),
      timer_(parts.io) {
  watch();
}

PushDesk::OpenPtr PushDesk::find(const std::string& id) const {
  const auto found = std::ranges::find_if(open_, [&](auto& open) { return open->push.id() == id; });
  return found == open_.end() ? nullptr : *found;
}

PushDesk::OpenPtr PushDesk::under_way_to(const std::vector<std::string>& targets) const {
  for (const auto& open : open_)
    if (open->push.is_ours() && !open->push.is_over() &&
        overlap(open->push.order().targets, targets))
      return open;
  return nullptr;
}

PushDesk::OpenPtr PushDesk::keep(Push push, Finish finish) {
  open_.push_back(std::make_shared<Open>(Open{std::move(push), std::move(finish)}));
  const auto oldest_over =
      std::ranges::find_if(open_, [](auto& each) { return each->push.is_over(); });
  if (open_.size() > kMostOpen && oldest_over != open_.end()) open_.erase(oldest_over);
  return open_.back();
}

void PushDesk::order(PushOrder order, Finish finish) {
  auto targets = targets_of(order.targets, parts_.team);
  if (const auto there = require_targets(order, targets, parts_.team); !there)
    return finish(there.error());
  if (const auto other = under_way_to(order.targets))
    return finish(under_way(other->push.record()));
  if (const auto other = stale(order, targets, parts_.team))
    return refuse_stale(order, *other, std::move(finish));
  const PushIdentity identity{
      .id = new_id(), .rollback_id = new_id(), .pushed_ns = wire::wall_clock_ns()};
  advance(*keep(Push(std::move(order), std::move(targets), identity), std::move(finish)));
}

void PushDesk::refuse_stale(const PushOrder& order, const Stale& stale, Finish finish) {
  parts_.worker.run([this, hash = stale.hash] { return parts_.history.last_push_of(hash); },
                    [replaces = order.replaces, stale, finish](const auto& by) {
                      finish(by ? replaced_meanwhile(replaces, stale, by.value())
                                : cannot_now(by.error().message));
                    },
                    [finish](const std::string& why) { finish(cannot_now(why)); });
}

void PushDesk::cancel(const std::string& id, const std::string& who, const Finish& finish) {
  const auto open = find(id);
  if (!open) return finish(not_found("No push '" + id + "' is under way."));
  if (const auto cancelled = open->push.cancel(who); !cancelled) return finish(cancelled.error());
  advance(*open);
  finish(open->push.record());
}

void PushDesk::describe(const std::string& id, Finish finish) {
  if (const auto open = find(id)) return finish(open->push.record());
  parts_.worker.run([this, id] { return parts_.history.push(id); },
                    [id, finish](const auto& found) {
                      if (!found) return finish(cannot_now(found.error().message));
                      if (found.value()) return finish(*found.value());
                      finish(not_found("There was no push '" + id + "'."));
                    },
                    [finish](const std::string& why) { finish(cannot_now(why)); });
}

void PushDesk::take(const std::string& id, const PushResult& result) {
  const auto open = find(id);
  if (!open) return;
  open->push.take(result, clock_.now());
  if (open->push.is_refused()) std::erase(open_, open);
  advance(*open);
}

// This must follow every event of a push. It carries the push's requests out and gives its answer.
void PushDesk::advance(Open& open) {
  auto& push = open.push;
  for (auto asked = push.take_requests(); !asked.empty(); asked = push.take_requests())
    for (auto& request : asked) {
      Result<void> begun;
      const auto carried_out =
          guarded("a push", [&] { begun = executor_.carry_out(push.id(), std::move(request)); });
      if (!carried_out) push.take(RequestFailed{carried_out.error().message}, clock_.now());
      if (!begun) push.fail(begun.error().message);
    }
  const auto answer = push.take_answer();
  if (answer && open.finish) std::exchange(open.finish, nullptr)(*answer);
}

void PushDesk::watch() {
  for (const auto& open : std::deque(open_))
    if (!open->push.is_over()) (void)guarded("watching a push", [&] { watch(*open); });
  timer_.expires_after(kWatchEach);
  timer_.async_wait([this](boost::system::error_code error) {
    if (!error) watch();
  });
}

void PushDesk::watch(Open& open) {
  auto& push = open.push;
  if (const Robot* canary = parts_.team.find(push.order().canary); canary && canary->state)
    push.see_canary(parts_.team.silent(*canary), canary->state->program_hash, clock_.now());
  if (const Trial* trial = executor_.trial(push.id()))
    push.see_trial(trial->finished_runs(), trial->all_runs());
  push.update(clock_.now());
  advance(open);
}

// Each record waits for the disk. The monitor must not be held by a flood of them, nor at its end.
bool PushDesk::has_room_for_others() {
  constexpr std::size_t kMost = 32;
  constexpr Duration kWithin = std::chrono::seconds(10);
  const Time now = clock_.now();
  while (!others_.empty() && now - others_.front() > kWithin) others_.pop_front();
  if (others_.size() >= kMost) return false;
  others_.push_back(now);
  return true;
}

void PushDesk::note(const msg::ProgramPush& told) {
  if (find(told.id)) return;
  if (!has_room_for_others())
    return refusals_.note(wire::kProgramPushTopic,
                          "more pushes than others make by hand are not recorded");
  const msg::ProgramPush message = not_of_the_future(told);
  const auto targets = targets_of(message.targets, parts_.team);
  if (message.targets.empty()) parts_.team.note_push(message.hash);
  advance(*keep(Push::of_others(message, targets, clock_.now()), nullptr));
}

void PushDesk::note(const msg::ProgramReply& reply) {
  const auto open =
      std::ranges::find_if(open_, [&](const auto& each) { return each->push.is_meant_by(reply); });
  if (open == open_.end()) return;
  const auto dropped = (*open)->push.replies_dropped();
  (*open)->push.take_reply(reply, clock_.now());
  if ((*open)->push.replies_dropped() != dropped)
    refusals_.note(wire::Refusals::kOthers,
                   "of the robots that reply to a push and were not asked, the newest " +
                       std::to_string(Replies::kMostUnasked) + " are kept");
  advance(**open);
}

}  // namespace galilean::monitor
