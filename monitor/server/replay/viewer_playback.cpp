// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/replay/viewer_playback.h"

#include <algorithm>
#include <utility>

#include "core/wire/ros_time.h"
#include "monitor/record/times.h"
#include "monitor/server/foxglove/foxglove_messages.h"

namespace galilean::monitor {
namespace {

constexpr Duration kTimeEach = std::chrono::milliseconds(100);
constexpr Duration kLongestHold = std::chrono::seconds(1);
/// So much is sent before orders are looked at again.
constexpr std::size_t kBatchBytes = std::size_t{256} << 10;

constexpr std::size_t kMostSubscriptions = 10'000;

using foxglove::StatusLevel;

std::string advertised(const std::vector<RecordedTopic>& topics) {
  std::vector<foxglove::AdvertisedChannel> channels;
  for (const auto& topic : topics)
    channels.push_back({topic.id, topic.topic, topic.encoding, topic.schema_name,
                        topic.schema_encoding, topic.schema});
  return foxglove::advertise(channels);
}

Payload payload_of(const mcap::Message& message) {
  return std::make_shared<const std::vector<std::uint8_t>>(message.data.begin(),
                                                           message.data.end());
}

}  // namespace

ViewerPlayback::ViewerPlayback(const ViewedRecording& recording, PlaybackLine& line,
                               const Clock& real, Duration at)
    : recording_(recording),
      line_(line),
      real_(real),
      player_(*recording.source, recording.summary, recording.topics, real),
      damage_(recording),
      plays_at_(real.now() + kLongestHold) {
  player_.pause(true);
  if (at > Duration{}) player_.seek(player_.start_ns() + static_cast<std::uint64_t>(at.count()));
  const foxglove::RecordingInfo info{recording.name + ", recorded " + iso_time(player_.start_ns()),
                                     player_.start_ns(), player_.end_ns()};
  add(text_frame(foxglove::server_info(info, std::to_string(wire::wall_clock_ns()))));
  for (const auto& sentence : damage_.known()) add_status(false, sentence);
  add(text_frame(advertised(recording.topics)));
  add(playback_state_frame(state()));
  flush();
}

Duration ViewerPlayback::step() {
  // An answer would only wait behind what waits. So a viewer that does not read, but asks, cannot
  // fill the memory with answers.
  if (line_.has_room()) obey(line_.take_orders());
  if (plays_at_ && real_.now() >= *plays_at_) begin_to_play();
  send_due();
  tell_damage();
  tell_state();
  flush();
  const auto until_time = std::max(Duration{}, next_time_ - real_.now());
  if (!line_.has_room()) return until_time;
  return std::min(until_time, player_.until_next().value_or(until_time));
}

void ViewerPlayback::obey(const std::vector<PlaybackOrder>& orders) {
  const auto seeks = [](const PlaybackOrder& order) {
    const auto* request = std::get_if<PlaybackRequest>(&order);
    return request && request->seek_ns;
  };
  // Who drags along a recording asks faster than a disk reads: only the last place counts.
  const auto last_seek = std::find_if(orders.rbegin(), orders.rend(), seeks);
  bool changed = false;
  for (const auto& order : orders) {
    if (const auto* subscribed = std::get_if<Subscribe>(&order)) subscribe(*subscribed);
    if (const auto* unsubscribed = std::get_if<Unsubscribe>(&order)) unsubscribe(*unsubscribed);
    changed |= !std::holds_alternative<PlaybackRequest>(order);
  }
  if (changed) subscriptions_changed();
  for (const auto& order : orders)
    if (const auto* request = std::get_if<PlaybackRequest>(&order))
      obey(*request, last_seek != orders.rend() && &order == &*last_seek);
}

void ViewerPlayback::obey(const PlaybackRequest& request, bool is_last_seek) {
  if (request.speed >= SeekablePlayer::kLeastSpeed && request.speed <= SeekablePlayer::kMostSpeed)
    player_.set_speed(static_cast<double>(request.speed));
  else
    add_status(true, "A replay's speed is from 0.1 to 100; this one keeps its speed.");
  wants_pause_ = request.pause;
  begin_to_play();
  if (is_last_seek) player_.seek(*request.seek_ns);
  auto answer = state();
  answer.did_seek = request.seek_ns.has_value();
  answer.request_id = request.id;
  told_ = answer.status;
  add(playback_state_frame(answer));
  next_time_ = real_.now();  // so that the new time is told at once
}

void ViewerPlayback::begin_to_play() {
  plays_at_.reset();
  player_.pause(wants_pause_);
}

void ViewerPlayback::subscribe(const Subscribe& order) {
  const auto topic = std::ranges::find(recording_.topics, order.channel_id, &RecordedTopic::id);
  if (topic == recording_.topics.end())
    return add_status(true, "There is no channel " + std::to_string(order.channel_id) + ".");
  if (topic_of_.size() >= kMostSubscriptions)
    return add_status(true, "A replay keeps at most 10000 subscriptions.");
  if (!topic_of_.emplace(order.subscription_id, &*topic).second)
    add_status(true,
               "Subscription id " + std::to_string(order.subscription_id) + " is in use already.");
}

void ViewerPlayback::unsubscribe(const Unsubscribe& order) {
  if (topic_of_.erase(order.subscription_id) == 0)
    add_status(false, "There is no subscription " + std::to_string(order.subscription_id) + ".");
}

void ViewerPlayback::subscriptions_changed() {
  subscriptions_of_.clear();
  RecordingCursor::Channels wanted;
  for (const auto& [id, topic] : topic_of_)
    for (const auto channel : topic->channels) {
      subscriptions_of_[channel].push_back(id);
      wanted.insert(channel);
    }
  player_.want(std::move(wanted));
  if (plays_at_ && !topic_of_.empty()) begin_to_play();
}

void ViewerPlayback::send_due() {
  if (!line_.has_room()) return;
  for (std::size_t bytes = 0; bytes < kBatchBytes;) {
    const auto* message = player_.due();
    if (!message) return;
    const auto payload = payload_of(*message);
    const auto& subscriptions = subscriptions_of_[message->channel_id];
    for (const auto subscription : subscriptions)
      add(message_frame(subscription, message->log_ns, payload));
    bytes += payload->size() + (subscriptions.size() + 1) * sizeof(Frame);
    player_.take();
  }
}

void ViewerPlayback::tell_damage() {
  for (const auto& sentence : damage_.newly(player_.take_damages())) add_status(false, sentence);
}

void ViewerPlayback::tell_state() {
  const auto now = state();
  if (now.status != told_) add(playback_state_frame(now));
  told_ = now.status;
  if (real_.now() < next_time_) return;
  batch_.time = time_frame(static_cast<std::int64_t>(now.now_ns));
  next_time_ = real_.now() + kTimeEach;
}

PlaybackState ViewerPlayback::state() const {
  PlaybackState state{.now_ns = player_.now_ns(), .speed = static_cast<float>(player_.speed())};
  switch (player_.status()) {
    case SeekablePlayer::Status::kPlaying:
      state.status = PlaybackStatus::kPlaying;
      break;
    case SeekablePlayer::Status::kPaused:
      state.status = plays_at_ ? PlaybackStatus::kBuffering : PlaybackStatus::kPaused;
      break;
    case SeekablePlayer::Status::kEnded:
      state.status = PlaybackStatus::kEnded;
      break;
  }
  return state;
}

void ViewerPlayback::add_status(bool is_error, const std::string& sentence) {
  add(text_frame(
      foxglove::status(is_error ? StatusLevel::kError : StatusLevel::kWarning, sentence)));
}

void ViewerPlayback::flush() {
  if (batch_.frames.empty() && !batch_.time) return;
  line_.send(std::exchange(batch_, {}));
}

void play_to_viewer(const RecordingFolder& folder, const std::string& name, Duration at,
                    PlaybackLine& line) {
  const auto recording = ViewedRecording::open(folder, name);
  if (!recording) return line.send({.frames = {}, .end_reason = recording.error().message});
  const SteadyClock clock;
  ViewerPlayback playback(recording.value(), line, clock, at);
  Duration rest{};
  while (line.wait(rest)) rest = playback.step();
}

}  // namespace galilean::monitor
