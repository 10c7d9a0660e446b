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
      late_(parts.worker, parts.history, parts.team,
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

void PushDesk::order(PushOrder order, Finish finish) {
  if (order.id.empty()) {
    order.id = new_id();
    return begin(std::move(order), finish);
  }
  if (answer_again(order.id, finish)) return;
  parts_.worker.run([this, id = order.id] { return parts_.history.push(id); },
                    [this, order, finish](const auto& found) {
                      if (!found) return finish(cannot_now(found.error().message));
                      if (found.value()) return finish(*found.value());
                      // The same order may have begun while the history was asked.
                      if (!answer_again(order.id, finish)) begin(order, finish);
                    },
                    [finish](const std::string& why) { finish(cannot_now(why)); });
}

bool PushDesk::answer_again(const std::string& id, const Finish& finish) {
  if (const auto open = find(id)) {
    if (!open->push.is_ours() || open->answer)
      finish(open->answer && !*open->answer ? *open->answer : PushAnswer(open->push.record()));
    else
      open->finish.push_back(finish);
    return true;
  }
  const auto refused = std::ranges::find(refused_, id, &std::pair<std::string, Refusal>::first);
  if (refused == refused_.end()) return false;
  finish(PushAnswer(refused->second));
  return true;
}

void PushDesk::begin(PushOrder order, const Finish& finish) {
  auto targets = targets_of(order.targets, parts_.team);
  if (const auto there = require_targets(order, targets, parts_.team); !there)
    return refuse(order.id, there.error(), finish);
  if (const auto other = under_way_to(order.targets))
    return refuse_under_way(order, other->push.record(), runs_now(order, targets, parts_.team),
                            finish);
  if (const auto other = stale(order, targets, parts_.team))
    return refuse_stale(order, *other, finish);
  const PushIdentity identity{
      .id = order.id, .rollback_id = new_id(), .pushed_ns = wire::wall_clock_ns()};
  late_.supersede(order.targets);
  advance(*keep(Push(std::move(order), std::move(targets), identity), {finish}));
}

void PushDesk::refuse(const std::string& id, const Refusal& refusal, const Finish& finish) {
  refused_.emplace_back(id, refusal);
  if (refused_.size() > kMostRefused) refused_.pop_front();
  finish(PushAnswer(refusal));
}

void PushDesk::refuse_stale(const PushOrder& order, const Stale& stale, const Finish& finish) {
  parts_.worker.run(
      [this, hash = stale.hash] { return parts_.history.last_push_of(hash); },
      [this, id = order.id, replaces = order.replaces, stale, finish](const auto& by) {
        refuse(
            id,
            by ? replaced_meanwhile(replaces, stale, by.value()) : cannot_now(by.error().message),
            finish);
      },
      [finish](const std::string& why) { finish(cannot_now(why)); });
}

void PushDesk::refuse_under_way(const PushOrder& order, const PushRecord& other,
                                const std::string& running_hash, const Finish& finish) {
  parts_.worker.run([this, running_hash] { return parts_.history.last_push_of(running_hash); },
                    [this, id = order.id, other, running_hash, finish](const auto& by) {
                      refuse(id,
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
  after_writes([finish, record = open->push.record()] { finish(record); });
}

// The worker does one job after another: what is told by `then` is in the history before.
void PushDesk::after_writes(const std::function<void()>& then) {
  parts_.worker.run([] { return true; }, [then](bool /*done*/) { then(); },
                    [then](const std::string& /*why*/) { then(); });
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
  if (const auto answer = push.take_answer()) give(open, *answer);
  if (push.is_over() && push.is_ours() && !std::exchange(open.is_told_over, true))
    late_.add(push.record());
}

void PushDesk::give(Open& open, const PushAnswer& answer) {
  open.answer = answer;
  if (!answer) {
    refused_.emplace_back(open.push.id(), answer.error());
    if (refused_.size() > kMostRefused) refused_.pop_front();
  }
  after_writes([waiting = std::exchange(open.finish, {}), answer] {
    for (const auto& finish : waiting) finish(answer);
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
bool PushDesk::has_room_for_others() {
  constexpr std::size_t kMost = 32;
  constexpr Duration kWithin = std::chrono::seconds(10);
  const Time now = clock_.now();
  while (!others_.empty() && now - others_.front() > kWithin) others_.pop_front();
  if (others_.size() >= kMost) return false;
  others_.push_back(now);
  return true;
}

void PushDesk::note(const msg::ProgramPush& announced) {
  if (find(announced.id)) return;
  if (bytes_of(announced) > kMostBytesOfOthers)
    return refusals_.note(wire::kProgramPushTopic,
                          "programs of more than 1 MB that others push are not recorded");
  if (!has_room_for_others())
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
