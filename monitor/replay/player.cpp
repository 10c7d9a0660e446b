// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/replay/player.h"

#include <algorithm>
#include <utility>

namespace galilean::monitor {
namespace {

/// The number of events that a writer keeps for late joiners.
constexpr std::size_t kEventsKept = 64;

}  // namespace

Player::Player(const std::map<std::uint16_t, Track>& tracks, Pace pace, const Clock& clock,
               Send send, Wait wait)
    : tracks_(tracks), pace_(pace), clock_(clock), send_(std::move(send)), wait_(std::move(wait)) {}

mcap::ScanEnd Player::play(const mcap::ByteSource& recording, std::uint64_t start_ns) {
  from_ns_ = start_ns + static_cast<std::uint64_t>(pace_.from.count());
  began_ = clock_.now();
  mcap::Visitor visitor;
  visitor.message = [this](const mcap::Message& message) { meet(message); };
  visitor.enough = [this] { return !playing_; };
  return mcap::scan(recording, visitor);
}

void Player::meet(const mcap::Message& message) {
  const auto track = tracks_.find(message.channel_id);
  if (track == tracks_.end()) return;
  if (message.log_ns < from_ns_) return keep(message, track->second.delivery);
  if (!kept_.empty()) tell_kept();
  playing_ = wait_(due(message.log_ns));
  if (playing_) send(message.channel_id, message.data);
}

void Player::keep(const mcap::Message& message, wire::Delivery delivery) {
  const bool is_event = delivery == wire::Delivery::kEvent;
  if (!is_event && delivery != wire::Delivery::kState) return;
  auto& kept = kept_[message.channel_id];
  if (kept.size() >= (is_event ? kEventsKept : 1)) kept.erase(kept.begin());
  kept.push_back({message.log_ns, message.channel_id, {message.data.begin(), message.data.end()}});
}

void Player::tell_kept() {
  began_ = clock_.now();  // because reading the skipped messages took time
  std::vector<Kept> all;
  for (auto& [channel, kept] : kept_) std::ranges::move(kept, std::back_inserter(all));
  kept_.clear();
  std::ranges::stable_sort(all, {}, &Kept::log_ns);
  for (const auto& [log_ns, channel, cdr] : all) send(channel, cdr);
}

void Player::send(std::uint16_t channel, mcap::ByteView cdr) {
  send_(channel, cdr);
  ++sent_;
}

Time Player::due(std::uint64_t log_ns) const {
  const auto since = static_cast<double>(log_ns - from_ns_);
  return began_ + Duration(static_cast<Duration::rep>(since / pace_.rate));
}

}  // namespace galilean::monitor
