// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/push_desk.h"

#include <algorithm>
#include <iostream>
#include <utility>
#include <variant>

#include "core/wire/ros_time.h"
#include "core/wire/topic_names.h"
#include "monitor/background/guarded.h"
#include "monitor/pushes/history/push_messages.h"

namespace galilean::monitor {
namespace {

/// The number of pushes that are kept, unless more are under way. Late replies to older pushes,
/// such as rollbacks, are ignored.
constexpr std::size_t kMostOpen = 64;
/// The number of refusals that are remembered for an order that comes twice.
constexpr std::size_t kMostRefused = 64;
constexpr auto kWatchEach = std::chrono::milliseconds(50);

/// Programs of a team have a part of it. To keep one of others takes time and room, and anybody can
/// send one.
constexpr std::size_t kMostBytesOfOthers = std::size_t{1} << 20;

std::size_t bytes_of(const msg::ProgramPush& push) {
  std::size_t bytes = 0;
  for (const auto& file : push.files) bytes += file.path.size() + file.text.size();
  return bytes;
}

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
      late_(parts.worker, parts.history, parts.team, clock,
            [this](const PushRecord& push) {
              // From now on the history describes it.
              std::erase_if(open_, [&](const auto& each) { return each->push.id() == push.id; });
              executor_.publish(push);
            }),
      timer_(parts.io) {
  late_.start();
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

PushDesk::OpenPtr PushDesk::keep(Push push, std::vector<Finish> finish) {
  open_.push_back(std::make_shared<Open>(Open{std::move(push), std::move(finish)}));
  const auto oldest_over =
      std::ranges::find_if(open_, [](auto& each) { return each->push.is_over(); });
  if (open_.size() > kMostOpen && oldest_over != open_.end()) open_.erase(oldest_over);
  return open_.back();
}

void PushDesk::order(PushOrder order, const Admit& admit, const Finish& finish) {
  if (order.id.empty()) {
    order.id = new_id();
    if (admit()) begin(order, finish);
    return;
  }
  if (answer_again(order.id, finish)) return;
  parts_.worker.run([this, id = order.id] { return kept_answer(parts_.history, id); },
                    [this, order, admit, finish](const auto& kept) {
                      if (!kept) return finish(cannot_now(kept.error().message));
                      if (kept.value()) return finish(*kept.value());
                      // The same order may have begun while the history was asked.
                      if (!answer_again(order.id, finish) && admit()) begin(order, finish);
                    },
                    [finish](const std::string& why) { finish(cannot_now(why)); });
}

Result<std::optional<PushAnswer>> PushDesk::kept_answer(const History& history,
                                                        const std::string& id) {
  using Kept = std::optional<PushAnswer>;
  const auto push = history.push(id);
  if (!push) return push.error();
  if (push.value()) return Kept(PushAnswer(*push.value()));
  const auto refused = history.refused_push(id);
  if (!refused) return refused.error();
  return refused.value() ? Kept(PushAnswer(refused_before(*refused.value()))) : Kept();
}

bool PushDesk::answer_again(const std::string& id, const Finish& finish) {
  if (const auto open = find(id)) {
    if (open->push.is_ours() && !open->answer)
      open->finish.push_back(finish);
    else
      give({finish}, open->answer && !*open->answer ? *open->answer : open->push.record());
    return true;
  }
  const auto refused = std::ranges::find(refused_, id, &std::pair<std::string, Refusal>::first);
  if (refused == refused_.end()) return false;
  finish(PushAnswer(refused->second));
  return true;
}

void PushDesk::begin(const PushOrder& order, const Finish& finish) {
  // It may have begun while it waited for another push's check.
  if (answer_again(order.id, finish)) return;
  auto targets = targets_of(order.targets, parts_.team);
  if (const auto there = require_targets(order, targets, parts_.team); !there)
    return refuse(order, there.error(), finish);
  if (const auto other = under_way_to(order.targets)) {
    const auto record = other->push.record();
    // Who comes second is told which program came first, and that is known once it is checked.
    if (record.hash.empty())
      return other->after_check.push_back([this, order, finish] { begin(order, finish); });
    return refuse_under_way(order, record, runs_now(order, targets, parts_.team), finish);
  }
  if (const auto other = stale(order, targets, parts_.team))
    return refuse_stale(order, *other, finish);
  const PushIdentity identity{
      .id = order.id, .rollback_id = new_id(), .pushed_ns = wire::wall_clock_ns()};
  advance(*keep(Push(order, std::move(targets), identity), {finish}));
}

void PushDesk::refuse(const PushOrder& order, const Refusal& refusal, const Finish& finish) {
  remember({.id = order.id,
            .pushed_ns = wire::wall_clock_ns(),
            .author = order.author,
            .program = order.files.empty() ? std::string() : order.files.front().path,
            .hash = {},
            .targets = order.targets},
           refusal);
  give({finish}, refusal);
}

// A refusal that may pass, such as that of a disk that fails, is for this monitor alone. A flood of
// them must not fill the history.
void PushDesk::remember(const PushRecord& push, const Refusal& refusal) {
  refused_.emplace_back(push.id, refusal);
  if (refused_.size() > kMostRefused) refused_.pop_front();
  if (refusal.reason == Refusal::Reason::kUnavailable || !has_room(kept_refusals_)) return;
  parts_.worker.run([this, kept = kept_form(refusal, push)] {
    if (const auto done = parts_.history.add_refused_push(kept); !done)
      std::clog << "galilean-monitor: a refused push was not kept: " << done.error().message
                << std::endl;
  });
}

void PushDesk::refuse_stale(const PushOrder& order, const Stale& stale, const Finish& finish) {
  parts_.worker.run([this, hash = stale.hash] { return parts_.history.last_push_of(hash); },
                    [this, order, stale, finish](const auto& by) {
                      refuse(order,
                             by ? replaced_meanwhile(order.replaces, stale, by.value())
                                : cannot_now(by.error().message),
                             finish);
                    },
                    [finish](const std::string& why) { finish(cannot_now(why)); });
}

void PushDesk::refuse_under_way(const PushOrder& order, const PushRecord& other,
                                const std::string& running_hash, const Finish& finish) {
  parts_.worker.run([this, running_hash] { return parts_.history.last_push_of(running_hash); },
                    [this, order, other, running_hash, finish](const auto& by) {
                      refuse(order,
                             by ? under_way(other, running_hash, by.value())
                                : under_way(other, running_hash, std::nullopt),
                             finish);
                    },
                    [other, running_hash, finish](const std::string& /*why*/) {
                      finish(under_way(other, running_hash, std::nullopt));
                    });
}

void PushDesk::cancel(const std::string& id, const std::string& who, const Finish& finish) {
  const auto open = find(id);
  if (!open) return finish(not_found("No push '" + id + "' is under way."));
  if (const auto cancelled = open->push.cancel(who); !cancelled) return finish(cancelled.error());
  advance(*open);
  give({finish}, open->push.record());
}

// The worker does one job after another: what is told by `then` is in the history before.
void PushDesk::after_writes(const std::function<void(const std::string& not_kept)>& then) {
  parts_.worker.run([this] { return parts_.history.not_kept(); }, then, then);
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
      // From here on the targets may run it, and what they tell is of this push.
      if (const auto* send = std::get_if<SendProgram>(&request))
        late_.supersede(send->push.targets);
      const auto carried_out =
          guarded("a push", [&] { begun = executor_.carry_out(push.id(), std::move(request)); });
      if (!carried_out) push.take(RequestFailed{carried_out.error().message}, clock_.now());
      if (!begun) push.fail(begun.error().message);
    }
  if (const auto answer = push.take_answer()) give(open, *answer);
  if (push.is_over() && push.is_ours() && !std::exchange(open.is_told_over, true))
    late_.add(push.record());
  if (open.after_check.empty() || (!push.is_over() && push.record().hash.empty())) return;
  // One of them may drop this push, which is therefore not looked at any more.
  for (const auto& next : std::exchange(open.after_check, {})) next();
}

void PushDesk::give(Open& open, const PushAnswer& answer) {
  open.answer = answer;
  if (!answer) remember(open.push.record(), answer.error());
  give(std::exchange(open.finish, {}), answer);
}

void PushDesk::give(const std::vector<Finish>& waiting, const PushAnswer& answer) {
  after_writes([waiting, answer](const std::string& not_kept) {
    auto told = answer;
    if (told) told.value().not_kept = not_kept;
    for (const auto& finish : waiting) finish(told);
  });
}

void PushDesk::watch() {
  (void)guarded("what robots tell later", [this] { late_.watch(); });
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
bool PushDesk::has_room(std::deque<Time>& newest) const {
  constexpr std::size_t kMost = 32;
  constexpr Duration kWithin = std::chrono::seconds(10);
  const Time now = clock_.now();
  while (!newest.empty() && now - newest.front() > kWithin) newest.pop_front();
  if (newest.size() >= kMost) return false;
  newest.push_back(now);
  return true;
}

void PushDesk::note(const msg::ProgramPush& announced) {
  if (find(announced.id)) return;
  if (bytes_of(announced) > kMostBytesOfOthers)
    return refusals_.note(wire::kProgramPushTopic,
                          "programs of more than 1 MB that others push are not recorded");
  if (!has_room(others_))
    return refusals_.note(wire::kProgramPushTopic,
                          "more pushes than others make by hand are not recorded");
  const msg::ProgramPush message = not_of_the_future(announced);
  const auto targets = targets_of(message.targets, parts_.team);
  late_.supersede(message.targets);
  // Robots refuse a push that announces a wrong hash.
  if (message.targets.empty() && hash_of_files(message) == message.hash)
    parts_.team.note_push(message.hash);
  advance(*keep(Push::of_others(message, targets, clock_.now()), {}));
}

void PushDesk::note(const msg::ProgramReply& reply) {
  const auto open =
      std::ranges::find_if(open_, [&](const auto& each) { return each->push.is_meant_by(reply); });
  if (open == open_.end()) return late_.note(reply);
  const auto found = *open;
  const auto dropped = found->push.replies_dropped();
  found->push.take_reply(reply, clock_.now());
  if (found->push.replies_dropped() != dropped)
    refusals_.note(wire::Refusals::kOthers,
                   "of the robots that reply to a push and were not asked, the newest " +
                       std::to_string(Replies::kMostUnasked) + " are kept");
  advance(*found);
  if (found->push.is_over() && reply.id == found->push.id()) late_.note(reply);
}

}  // namespace galilean::monitor
