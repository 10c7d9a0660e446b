// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/playback/recording_cursor.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

namespace galilean::monitor {
namespace {

constexpr std::size_t kReadingBytes = std::size_t{16} << 20;
/// A search for a wanted message among others pauses after so many, so that orders are heard.
constexpr int kReadAtOnce = 20'000;

constexpr std::uint64_t kSecond_ns = 1'000'000'000;
constexpr std::uint64_t kEventsSince_ns = 30 * kSecond_ns;
constexpr std::uint64_t kOthersSince_ns = kSecond_ns;

std::uint64_t before(std::uint64_t at_ns, std::uint64_t span_ns) {
  return at_ns > span_ns ? at_ns - span_ns : 0;
}

/// Adds what tells of a topic's channels how things stood at an instant. States and events are the
/// topic's; other topics, such as /tf, have several writers of which each tells something else.
void add_wanted(wire::Delivery delivery, std::vector<std::uint16_t> channels, std::uint64_t at_ns,
                std::vector<mcap::NewestMessages::Wanted>& to) {
  const auto kept = wire::kept_for_late_joiners(delivery);
  switch (delivery) {
    case wire::Delivery::kState:
      to.push_back({std::move(channels), kept, 0});
      break;
    case wire::Delivery::kEvent:
    case wire::Delivery::kJournal:
      to.push_back({std::move(channels), kept, before(at_ns, kEventsSince_ns)});
      break;
    case wire::Delivery::kFlow:
    case wire::Delivery::kStream:
      for (const auto channel : channels)
        to.push_back({{channel}, 1, before(at_ns, kOthersSince_ns)});
      break;
    case wire::Delivery::kCommand:
    case wire::Delivery::kRecord:  // it tells what happened, and not how things stand
      break;
  }
}

}  // namespace

RecordingCursor::RecordingCursor(const mcap::ByteSource& source,
                                 const std::vector<mcap::Block>& blocks,
                                 const std::vector<RecordedTopic>& topics)
    : source_(source),
      blocks_(blocks),
      topics_(topics),
      block_channels_(source, blocks),
      newest_(source, blocks, block_channels_) {}

void RecordingCursor::move_to(std::uint64_t at_ns) {
  past_.clear();
  add_past(wanted_, at_ns);
  open_reader(at_ns);
}

void RecordingCursor::want(Channels channels, std::uint64_t at_ns) {
  Channels fresh;
  std::ranges::set_difference(channels, wanted_, std::inserter(fresh, fresh.end()));
  wanted_ = std::move(channels);
  std::erase_if(past_, [&](const auto& each) { return !wanted_.contains(each.head.channel_id); });
  if (!fresh.empty() || wanted_.empty()) {
    add_past(fresh, at_ns);
    open_reader(at_ns);  // because what is new was passed over up to the next message
  } else if (ahead_ && !wanted_.contains(ahead_->channel_id)) {
    ahead_ = nullptr;
  }
}

void RecordingCursor::add_past(const Channels& channels, std::uint64_t at_ns) {
  std::vector<mcap::NewestMessages::Wanted> wanted;
  for (const auto& topic : topics_) {
    std::vector<std::uint16_t> some;
    std::ranges::copy_if(topic.channels, std::back_inserter(some),
                         [&](std::uint16_t channel) { return channels.contains(channel); });
    if (!some.empty()) add_wanted(topic.delivery, std::move(some), at_ns, wanted);
  }
  auto found = newest_.before(at_ns, wanted);
  std::ranges::move(found.messages, std::back_inserter(past_));
  std::ranges::move(found.damages, std::back_inserter(damages_));
}

void RecordingCursor::open_reader(std::uint64_t at_ns) {
  damages_ = take_damages();  // of the reader that ends here
  ahead_ = nullptr;
  reader_.reset();  // first, so that two readers never hold their blocks
  damages_seen_ = 0;
  at_end_ = wanted_.empty();
  read_until_ns_ = read_before_ns_ = at_ns;
  if (at_end_) return;
  reader_ = std::make_unique<mcap::MessageReader>(
      source_, blocks_, kReadingBytes,
      mcap::MessageReader::Part{at_ns, [this](std::uint32_t block) { return has_wanted(block); }});
}

bool RecordingCursor::has_wanted(std::uint32_t block) {
  const auto* channels = block_channels_.of(block);
  return !channels || std::ranges::any_of(*channels, [this](const auto& each) {
    return wanted_.contains(each.channel_id);
  });
}

const mcap::Message* RecordingCursor::next() {
  if (!past_.empty()) {
    past_front_ = past_.front().message();
    return &past_front_;
  }
  if (!ahead_ && !at_end_) search_ahead();
  return ahead_;
}

void RecordingCursor::search_ahead() {
  for (int read = 0; read < kReadAtOnce; ++read) {
    const auto* message = reader_->next();
    if (!message) {
      at_end_ = true;
      return;
    }
    read_before_ns_ = std::exchange(read_until_ns_, message->log_ns);
    if (wanted_.contains(message->channel_id)) {
      ahead_ = message;
      return;
    }
  }
}

void RecordingCursor::take() {
  if (!past_.empty())
    past_.pop_front();
  else
    ahead_ = nullptr;
}

bool RecordingCursor::goes_on_at(std::uint64_t log_ns) {
  if (!ahead_ && !at_end_) search_ahead();
  return ahead_ && ahead_->log_ns == log_ns;
}

std::uint64_t RecordingCursor::read_until_ns() const noexcept {
  return ahead_ || !at_end_ ? read_until_ns_ : std::numeric_limits<std::uint64_t>::max();
}

std::vector<mcap::Damage> RecordingCursor::take_damages() {
  auto taken = std::exchange(damages_, {});
  if (!reader_) return taken;
  const auto& met = reader_->damages();
  taken.insert(taken.end(), met.begin() + static_cast<std::ptrdiff_t>(damages_seen_), met.end());
  damages_seen_ = met.size();
  return taken;
}

}  // namespace galilean::monitor
