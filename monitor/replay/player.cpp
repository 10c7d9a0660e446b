// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/replay/player.h"

#include <algorithm>
#include <utility>

#include "monitor/mcap/message_reader.h"

namespace galilean::monitor {

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
  time_.move_to(message.log_ns);
  if (pace_.until && time_.position_ns() > static_cast<std::uint64_t>(pace_.until->count())) {
    if (!kept_.empty()) tell_kept();
    playing_ = false;
    return;
  }
  const auto track = tracks_.find(message.channel_id);
  if (track == tracks_.end()) return;
  if (time_.position_ns() < static_cast<std::uint64_t>(pace_.from.count()))
    return kept_.keep(message, track->second.delivery);
  if (!kept_.empty()) tell_kept();
  playing_ = wait_(due());
  if (playing_) send(message.channel_id, message.data);
}

void Player::tell_kept() {
  began_ = clock_.now();  // because reading the skipped messages took time
  kept_.give([&](const mcap::Message& message) { send(message.channel_id, message.data); });
}

void Player::send(std::uint16_t channel, mcap::ByteView cdr) {
  send_(channel, cdr);
  ++sent_;
}

std::optional<std::uint64_t> Player::log_now_ns() const {
  if (!time_.has_begun()) return std::nullopt;
  const auto played_ns = static_cast<double>((clock_.now() - began_).count()) * pace_.rate;
  const auto position_ns = static_cast<std::uint64_t>(
      std::max(0.0, static_cast<double>(pace_.from.count()) + played_ns));
  return time_.log_ns_at(std::min(position_ns, time_.position_ns()));
}

Time Player::due() const {
  const auto since_ns =
      static_cast<double>(time_.position_ns() - static_cast<std::uint64_t>(pace_.from.count()));
  return began_ + Duration(static_cast<Duration::rep>(since_ns / pace_.rate));
}

}  // namespace galilean::monitor
