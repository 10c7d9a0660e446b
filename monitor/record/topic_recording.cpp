// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/topic_recording.h"

#include <utility>

#include "core/wire/untyped_topic.h"

namespace galilean::monitor {

TopicRecording::Kind TopicRecording::kind_of(const wire::EndpointInfo& writer) {
  return {writer.topic, writer.dds_type, writer.keyed, writer.qos.exclusive};
}

TopicRecording::Offer TopicRecording::offer_of(const wire::EndpointInfo& writer) noexcept {
  return {writer.qos.reliable,
          writer.qos.durability >= wire::EndpointQos::Durability::kTransientLocal};
}

TopicRecording::TopicRecording(wire::Participant& participant, Kind kind, int depth,
                               std::function<void()> on_data)
    : participant_(participant),
      kind_(std::move(kind)),
      depth_(depth),
      on_data_(std::move(on_data)) {}

TopicRecording::~TopicRecording() {
  readers_.clear();  // before `ready_`, which they set
}

void TopicRecording::follow(const wire::EndpointInfo& writer) {
  Writer& followed = writers_[writer.guid];
  followed.info = writer;  // its process may have got a name meanwhile
  writer_of_handle_[writer.handle] = &followed;
  read_what_is(offer_of(writer));
}

void TopicRecording::read_what_is(Offer offered) {
  if (readers_.contains(offered)) return;
  wire::EndpointQos asked;
  asked.reliable = offered.reliable;
  asked.exclusive = kind_.exclusive;
  if (offered.kept) asked.durability = wire::EndpointQos::Durability::kTransientLocal;
  const wire::UntypedTopic topic{kind_.topic, kind_.dds_type, kind_.keyed};
  auto reader = std::make_unique<wire::Reader>(participant_, topic, asked, depth_);
  reader->on_data([this] {
    ready_ = true;
    on_data_();
  });
  readers_.emplace(offered, std::move(reader));
  ready_ = true;  // because messages may have come before the callback was set
  on_data_();
}

void TopicRecording::take(const Receive& receive) {
  if (!ready_.exchange(false)) return;
  for (const auto& [offered, reader] : readers_)
    reader->take([&, asked = offered](const wire::Received& received) {
      if (!takes_from(asked, received.writer)) return;
      Writer& writer = writer_of(received.writer);
      // On a topic with keys those messages have numbers, too, that end a key and never get here.
      if (writer.tally.note(kind_.keyed ? 0 : received.sequence)) receive(received, writer);
    });
}

/// Each writer's messages are taken from the reader that asks for what it offers. Those of a writer
/// that left before it was followed are taken from the reader that asks for least.
bool TopicRecording::takes_from(Offer asked, std::uint64_t writer) const {
  const auto known = writer_of_handle_.find(writer);
  if (known == writer_of_handle_.end()) return asked == readers_.begin()->first;
  return asked == offer_of(known->second->info);
}

TopicRecording::Writer& TopicRecording::writer_of(std::uint64_t handle) {
  const auto known = writer_of_handle_.find(handle);
  if (known != writer_of_handle_.end()) return *known->second;
  const auto info = unknown_writer(handle);
  Writer& writer = writers_[info.guid];
  writer.info = info;
  return *(writer_of_handle_[handle] = &writer);
}

/// It is taken to define its messages as another writer of the topic does.
wire::EndpointInfo TopicRecording::unknown_writer(std::uint64_t handle) const {
  const Offer weakest = readers_.begin()->first;
  wire::EndpointInfo info;
  if (!writers_.empty()) info.type_hash = writers_.begin()->second.info.type_hash;
  info.writes = true;
  info.topic = kind_.topic;
  info.dds_type = kind_.dds_type;
  info.keyed = kind_.keyed;
  info.process = "a process that left";
  info.qos.reliable = weakest.reliable;
  info.qos.exclusive = kind_.exclusive;
  if (weakest.kept) info.qos.durability = wire::EndpointQos::Durability::kTransientLocal;
  info.handle = handle;
  info.guid = "handle " + std::to_string(handle);
  return info;
}

}  // namespace galilean::monitor
