// SPDX-License-Identifier: BSD-3-Clause
#include "robot/telemetry/order_gate.h"

#include <utility>

#include "core/wire/ros_time.h"
#include "robot/telemetry/order_words.h"

namespace galilean::robot {
namespace {

constexpr const char* kOthers = "others";
/// The most names that are kept. A name that is forgotten is asked for again.
constexpr std::size_t kMostNames = 256;

std::string subject_of(const std::string& sender) {
  return "orders from " + sender;
}

/// Returns whether a problem of so many orders is told anew: at 1, 10, 100 and so on, because each
/// change of a problem is a line in the log. `before` is the count that was told last.
bool reaches_power_of_ten(std::uint64_t before, std::uint64_t now) {
  std::uint64_t power = 1;
  while (power <= before && power <= UINT64_MAX / 10) power *= 10;
  return now >= power;
}

}  // namespace

OrderGate::OrderGate(std::optional<TrustedKeys> trust, const Clock& clock, ThreadProblems& problems,
                     Times times, OrderMemory memory)
    : clock_(clock), problems_(problems), times_(std::move(times)), memory_(std::move(memory)) {
  if (trust) check_.emplace(std::move(*trust), memory_.before);
}

OrderGate::Times OrderGate::machine_times() {
  return [machine = SteadyClock()] {
    return CheckTimes{.now_ns = wire::wall_clock_ns(),
                      .uptime_ns = machine.now().time_since_epoch().count()};
  };
}

/// Requires: mutex_ is locked.
void OrderGate::note(std::string what, std::string why, Origin origin) {
  if (waiting_.size() < kMostWaiting)
    waiting_.push_back({std::move(what), std::move(why), std::move(origin)});
  else
    ++unnamed_;
}

void OrderGate::on_round() {
  if (!check_) return;
  std::deque<Refused> refused;
  std::uint64_t unnamed = 0;
  {
    const std::lock_guard lock(mutex_);
    refused.swap(waiting_);
    unnamed = std::exchange(unnamed_, 0);
  }
  for (const auto& each : refused) tell(each);
  if (unnamed > 0) tell_unnamed(unnamed);
  forget_old();
}

void OrderGate::tell(const Refused& refused) {
  const std::string name = name_of(refused.origin);
  const bool is_known = tallies_.contains(name) || tallies_.size() < kMostSenders;
  count(is_known ? name : kOthers, refused.what + name + " was refused: " + refused.why + ".", 1);
}

void OrderGate::tell_unnamed(std::uint64_t number) {
  count(kOthers, "Orders came faster than their senders could be looked up, and were refused.",
        number);
}

std::string OrderGate::name_of(const Origin& origin) {
  if (const auto found = names_.find(origin.writer); found != names_.end()) return found->second;
  const auto sender = origin.sender();
  if (names_.size() >= kMostNames) names_.clear();
  return names_[origin.writer] = words_of(sender);
}

void OrderGate::count(const std::string& sender, const std::string& sentence, std::uint64_t more) {
  Tally& tally = tallies_[sender];
  const std::uint64_t before = std::exchange(tally.refused, tally.refused + more);
  tally.last = clock_.now();
  if (!reaches_power_of_ten(before, tally.refused)) return;
  const std::string number = std::to_string(tally.refused);
  problems_.note(subject_of(sender), tally.refused == 1
                                         ? sentence
                                         : sentence + " So were " + number + " orders in all.");
}

void OrderGate::forget_old() {
  for (auto each = tallies_.begin(); each != tallies_.end();) {
    if (clock_.now() - each->second.last <= kForgetAfter) {
      ++each;
      continue;
    }
    problems_.note(subject_of(each->first), "");
    each = tallies_.erase(each);
  }
}

}  // namespace galilean::robot
