// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/replay/player.h"

#include <algorithm>
#include <utility>

#include "monitor/mcap/message_reader.h"

namespace galilean::monitor {
namespace {

/// The number of events that a writer keeps for late joiners.
constexpr std::size_t kEventsKept = 64;

}  // namespace

Player::Player(const std::map<std::uint16_t, Track>& tracks, Pace pace, const Clock& clock,
               Send send, Wait wait)
    : tracks_(tracks), pace_(pace), clock_(clock), send_(std::move(send)), wait_(std::move(wait)) {}

std::vector<mcap::Damage> Player::play(const mcap::ByteSource& recording,
                                       const std::vector<mcap::Block>& blocks) {
  began_ = clock_.now();
  mcap::MessageReader reader(recording, blocks);
  while (const mcap::Message* message = playing_ ? reader.next() : nullptr) meet(*message);
  return reader.damages();
}

void Player::meet(const mcap::Message& message) {
  move_to(message.log_ns);
  const auto track = tracks_.find(message.channel_id);
  if (track == tracks_.end()) return;
  if (position_ns_ < static_cast<std::uint64_t>(pace_.from.count()))
    return keep(message, track->second.delivery);
  if (!kept_.empty()) tell_kept();
  playing_ = wait_(due());
  if (playing_) send(message.channel_id, message.data);
}

void Player::move_to(std::uint64_t log_ns) {
  const std::uint64_t before_ns = log_ns_.value_or(log_ns);
  log_ns_ = std::max(before_ns, log_ns);
  if (log_ns <= before_ns) return;
  if (log_ns - before_ns > mcap::kLongestSilence_ns)
    silences_.push_back({before_ns, log_ns});
  else
    position_ns_ += log_ns - before_ns;
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

Time Player::due() const {
  const auto since_ns =
      static_cast<double>(position_ns_ - static_cast<std::uint64_t>(pace_.from.count()));
  return began_ + Duration(static_cast<Duration::rep>(since_ns / pace_.rate));
}

}  // namespace galilean::monitor
