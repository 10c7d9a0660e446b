// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/recorder.h"

#include <exception>
#include <utility>

#include "core/wire/reader.h"
#include "core/wire/ros_time.h"
#include "monitor/record/qos_profile.h"

namespace galilean::monitor {
namespace {

/// The number of messages of each writer that may wait while a chunk is compressed and written. It
/// is a minute of a robot's state or six seconds of images.
constexpr int kReaderDepth = 600, kImageDepth = 60;
constexpr std::string_view kRosPrefix = "rt";  // stands before ROS topics' names on DDS

bool is_image(std::string_view ros_type) {
  return ros_type == msg::CompressedImage::kRosType;
}

}  // namespace

struct Recorder::Subscription {
  std::uint16_t channel = 0;
  std::uint32_t sequence = 0;
  std::atomic<bool> ready{true};
  std::unique_ptr<wire::Reader> reader;
};

Recorder::Recorder(wire::Participant& participant, mcap::Writer& writer, Selection selection,
                   std::function<void(const std::string&)> warn)
    : participant_(participant),
      writer_(writer),
      selection_(std::move(selection)),
      warn_(std::move(warn)),
      discovery_(participant) {
  discovery_.on_change([this] {
    topics_changed_ = true;
    wake_.ring();
  });
  wake_.ring();
}

Recorder::~Recorder() {
  for (const auto& subscription : subscriptions_) subscription->reader.reset();
}

Result<void> Recorder::pump() {
  wake_.clear();
  if (topics_changed_.exchange(false)) subscribe_to_new();
  for (const auto& subscription : subscriptions_)
    if (subscription->ready.exchange(false))
      if (auto done = record(*subscription); !done) return done;
  return writer_.close_chunk_if_due(static_cast<std::uint64_t>(wire::wall_clock_ns()));
}

bool Recorder::selected(const std::string& name, std::string_view ros_type) const {
  if (!selection_.images && is_image(ros_type)) return false;
  return !selection_.topics || std::regex_search(name, *selection_.topics);
}

void Recorder::subscribe_to_new() {
  for (const auto& publication : discovery_.publications()) {
    const std::string& topic = publication.topic;
    if (!topic.starts_with("rt/") || !settled_.insert(topic).second) continue;
    const std::string name = topic.substr(kRosPrefix.size());
    const auto* schema = wire::find_schema_by_dds_type(publication.dds_type);
    if (!selected(name, schema ? schema->ros_type : "")) continue;
    if (schema)
      subscribe(topic, *schema);
    else
      warn_(name + " is not recorded: its type, " + publication.dds_type +
            ", is none of Galilean's messages");
  }
}

void Recorder::subscribe(const std::string& topic, const wire::Schema& schema) try {
  auto subscription = std::make_unique<Subscription>();
  subscription->reader =
      std::make_unique<wire::Reader>(participant_, topic, std::string(schema.ros_type),
                                     is_image(schema.ros_type) ? kImageDepth : kReaderDepth);
  subscription->channel = channel_for(topic.substr(kRosPrefix.size()), schema);
  subscription->reader->on_data([this, &ready = subscription->ready] {
    ready = true;
    wake_.ring();
  });
  wake_.ring();  // because messages may have come before the callback was set
  subscriptions_.push_back(std::move(subscription));
} catch (const std::exception& error) {
  warn_(topic.substr(kRosPrefix.size()) + " is not recorded: " + error.what());
}

std::uint16_t Recorder::channel_for(const std::string& name, const wire::Schema& schema) {
  const std::string type(schema.ros_type);
  auto known = schema_ids_.find(type);
  if (known == schema_ids_.end())
    known = schema_ids_.emplace(type, writer_.add_schema(type, "ros2idl", std::string(schema.idl)))
                .first;
  mcap::Channel channel;
  channel.schema_id = known->second;
  channel.topic = name;
  channel.message_encoding = "cdr";
  channel.metadata["offered_qos_profiles"] =
      offered_qos_profiles(wire::delivery_of(schema.ros_type));
  return writer_.add_channel(std::move(channel));
}

Result<void> Recorder::record(Subscription& subscription) {
  Result<void> done;
  subscription.reader->take([&](const wire::Received& received) {
    if (!done) return;
    done = writer_.write({subscription.channel, ++subscription.sequence,
                          static_cast<std::uint64_t>(wire::wall_clock_ns()),
                          static_cast<std::uint64_t>(received.sent_ns), received.cdr});
  });
  return done;
}

}  // namespace galilean::monitor
