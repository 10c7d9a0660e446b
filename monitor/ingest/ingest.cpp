// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/ingest/ingest.h"

#include <atomic>
#include <exception>
#include <utility>

#include "core/visible_text.h"
#include "core/wire/messages.h"
#include "core/wire/refusals.h"
#include "core/wire/ros_time.h"
#include "monitor/ingest/event_intake.h"

namespace galilean::monitor {

/// The state that Cyclone's threads share with the owner's thread.
struct Ingest::Signals {
  Wake wake;
  std::atomic<bool> pending{false};
  std::atomic<bool> topics_changed{true};

  void raise() {
    if (!pending.exchange(true)) wake();
  }
};

struct Ingest::Source {
  /// What a message says of how its robot is heard.
  enum class Kind { kState, kEvent, kOther };

  Channel channel;
  Kind kind = Kind::kOther;
  std::atomic<bool> has_data{false};
  bool rests = false;
  std::unique_ptr<wire::Reader> reader;
  std::map<std::uint64_t, bool> replays = {};  ///< by writer: whether a replay has it
  std::uint64_t messages = 0;
  std::size_t kept_bytes = 0;                       ///< as KeptBytes counts them
  Time newest{};                                    ///< when the newest of `messages` came
  EventIntake events = {};                          ///< of Kind::kEvent
  std::map<std::uint64_t, std::string> guids = {};  ///< by writer, as far as they were asked for

  [[nodiscard]] static Kind kind_of(std::string_view ros_type) noexcept;
  [[nodiscard]] bool is_replayed(const wire::Received& received);
  [[nodiscard]] std::string guid_of(std::uint64_t writer);
};

Ingest::Source::Kind Ingest::Source::kind_of(std::string_view ros_type) noexcept {
  if (ros_type == msg::RobotState::kRosType) return Kind::kState;
  return ros_type == msg::Transition::kRosType || ros_type == msg::ProgramReply::kRosType
             ? Kind::kEvent
             : Kind::kOther;
}

/// Asks discovery once for each writer. One that has left already keeps the number by which DDS
/// knew it.
std::string Ingest::Source::guid_of(std::uint64_t writer) {
  if (const auto known = guids.find(writer); known != guids.end()) return known->second;
  const auto guid = reader->guid_of(writer);
  if (guid.empty()) return "handle " + std::to_string(writer);
  if (guids.size() >= EventIntake::kMostWriters) guids.clear();
  return guids[writer] = guid;
}

/// Asks discovery once for each writer, because that takes longer than all else here. A writer that
/// has left already is asked for again.
bool Ingest::Source::is_replayed(const wire::Received& received) {
  constexpr std::size_t kMostWriters = 64;
  if (const auto known = replays.find(received.writer); known != replays.end())
    return known->second;
  const auto sender = reader->sender(received.writer);
  if (!sender) return false;
  if (replays.size() >= kMostWriters) replays.clear();
  return replays[received.writer] = sender->name == wire::kReplayName;
}

Ingest::Ingest(wire::Participant& participant, Callbacks callbacks, Wake wake,
               ReadAtOnce read_at_once)
    : participant_(participant),
      callbacks_(std::move(callbacks)),
      read_at_once_(std::move(read_at_once)),
      signals_(std::make_shared<Signals>()),
      discovery_(std::make_unique<wire::Discovery>(participant)) {
  signals_->wake = std::move(wake);
  discovery_->on_change([signals = signals_] {
    signals->topics_changed = true;
    signals->raise();
  });
  signals_->raise();
}

Ingest::~Ingest() {
  discovery_.reset();
  for (const auto& source : sources_) source->reader.reset();
}

bool Ingest::all_but_costly(const Channel& channel) {
  return channel.schema->ros_type != msg::CompressedImage::kRosType &&
         channel.schema->ros_type != msg::MarkerArray::kRosType;
}

void Ingest::poll() {
  signals_->pending = false;
  if (signals_->topics_changed.exchange(false)) discover();
  const Time until = clock_.now() + kLongestTurn;
  for (std::size_t left = sources_.size(); left > 0; --left) {
    Source& source = *sources_[next_++ % sources_.size()];
    if (!source.reader || source.rests || !source.has_data.exchange(false)) continue;
    take(source);
    if (clock_.now() < until) continue;
    // The rest waits for the next turn, which begins with the next topic.
    signals_->raise();
    return;
  }
}

void Ingest::take(Source& source) {
  const bool are_more = source.reader->take_some(kMostAtOnce, [&](const wire::Received& received) {
    bool filled = false;
    if (!follows(received) || !has_room_for(source, received) || !account(source, received, filled))
      return;
    ++source.messages;
    source.newest = clock_.now();
    callbacks_.message({source.channel, wire::wall_clock_ns(), received.sent_ns,
                        std::make_shared<const std::vector<std::uint8_t>>(received.cdr.begin(),
                                                                          received.cdr.end()),
                        source.is_replayed(received), filled});
  });
  if (!are_more) return;
  source.has_data = true;
  signals_->raise();
}

bool Ingest::account(Source& source, const wire::Received& received, bool& filled) {
  if (source.kind == Source::Kind::kOther || received.robot.empty()) return true;
  auto watch = cut_offs_.find(received.robot);
  if (watch == cut_offs_.end())
    watch = cut_offs_.emplace(std::string(received.robot), wire::CutOffWatch()).first;
  const Time now = clock_.now();
  if (source.kind == Source::Kind::kState) {
    watch->second.note_state(now, received.sent_ns);
    return true;
  }
  filled = watch->second.fills_gap(now, received.sent_ns);
  return source.events.note(source.guid_of(received.writer), received.sequence, filled);
}

// Only a valid message brings its robot here, so that a name that is only announced takes no place.
bool Ingest::follows(const wire::Received& received) {
  if (received.robot.empty()) return true;
  const auto admission = robots_.hear(received.robot, clock_.now());
  cut_offs_.erase(admission.forgotten);
  if (!admission.forgotten.empty() && callbacks_.forgotten)
    callbacks_.forgotten(admission.forgotten);
  if (admission.is_followed) return true;
  if (beyond_.empty())
    beyond_ = "more than " + std::to_string(kMostRobots) + " robots are not followed, such as " +
              std::string(received.robot);
  participant_.refusals().note(wire::Refusals::kOthers, beyond_);
  return false;
}

bool Ingest::has_room_for(Source& source, const wire::Received& received) {
  if (kept_bytes_.take(source.kept_bytes, source.channel.delivery, received.cdr.size()))
    return true;
  participant_.refusals().note(source.channel.topic,
                               "all topics' newest messages are longer than the monitor keeps");
  return false;
}

void Ingest::discover() {
  const auto fresh = discovery_->take_new(kMostNewTopics);
  for (const auto& publication : fresh.publications) add(publication);
  if (!fresh.are_more) return;
  // The rest waits for the next turn, so that what else the thread has to do comes between.
  signals_->topics_changed = true;
  signals_->raise();
}

bool Ingest::has_room_for(const wire::Publication& publication) {
  auto& of_process = topics_of_[publication.participant];
  if (sources_.size() < kMostTopics && of_process < kMostTopicsOfProcess) {
    ++of_process;
    return true;
  }
  if (topics_not_read_++ == 0 && callbacks_.problem)
    callbacks_.problem(visible(publication.topic) +
                       " and further topics are not read, because there are too many: at most " +
                       std::to_string(kMostTopics) + " are, and " +
                       std::to_string(kMostTopicsOfProcess) + " of one process");
  return false;
}

void Ingest::add(const wire::Publication& publication) {
  const auto* schema = wire::find_schema_by_dds_type(publication.dds_type);
  if (!schema || !publication.topic.starts_with("rt/") || by_topic_.contains(publication.topic) ||
      !has_room_for(publication))
    return;
  auto& source = *sources_.emplace_back(std::make_unique<Source>());
  source.channel = {static_cast<std::uint32_t>(sources_.size()), publication.topic, schema,
                    wire::delivery_of(schema->ros_type)};
  source.kind = Source::kind_of(schema->ros_type);
  by_topic_[publication.topic] = &source;
  if (callbacks_.channel) callbacks_.channel(source.channel);
  if (read_at_once_(source.channel)) open(source);
}

Intake Ingest::intake() const {
  Intake intake{.channels = {},
                .refused = participant_.refusals().counts(),
                .topics_not_read = topics_not_read_,
                .robots_forgotten = robots_.forgotten()};
  const Time now = clock_.now();
  for (const auto& source : sources_) {
    ChannelIntake& channel = intake.channels.emplace_back();
    channel.topic = source->channel.topic;
    channel.messages = source->messages;
    if (source->messages > 0) channel.age_s = to_seconds(now - source->newest);
    channel.filled = source->events.filled();
    channel.lost = source->events.lost();
  }
  return intake;
}

void Ingest::open(Source& source) try {
  const std::string type(source.channel.schema->ros_type);
  source.reader = source.kind == Source::Kind::kEvent
                      ? std::make_unique<wire::Reader>(participant_, source.channel.topic, type,
                                                       wire::Numbered{})
                      : std::make_unique<wire::Reader>(participant_, source.channel.topic, type);
  source.has_data = true;  // because messages may have come before the listener was set
  source.reader->on_data([signals = signals_, &source] {
    source.has_data = true;
    signals->raise();
  });
  signals_->raise();
} catch (const std::exception& error) {
  source.reader.reset();
  if (callbacks_.problem)
    callbacks_.problem(source.channel.topic + " cannot be read: " + error.what());
}

void Ingest::want(std::uint32_t channel_id, bool wanted) {
  if (channel_id == 0 || channel_id > sources_.size()) return;
  Source& source = *sources_[channel_id - 1];
  if (read_at_once_(source.channel) || wanted == (source.reader != nullptr)) return;
  if (wanted)
    open(source);
  else
    source.reader.reset();
}

void Ingest::rest(std::uint32_t channel_id, bool rests) {
  if (channel_id == 0 || channel_id > sources_.size()) return;
  sources_[channel_id - 1]->rests = rests;
}

}  // namespace galilean::monitor
