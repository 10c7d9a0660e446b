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

wire::EndpointQos TopicRecording::asked_of(const wire::EndpointInfo& writer) {
  const Offer offered = offer_of(writer);
  wire::EndpointQos asked;
  asked.reliable = offered.reliable;
  asked.exclusive = writer.qos.exclusive;
  if (offered.kept) asked.durability = wire::EndpointQos::Durability::kTransientLocal;
  return asked;
}

TopicRecording::~TopicRecording() {
  readers_.clear();  // before `ready_`, which they set
}

void TopicRecording::follow(const wire::EndpointInfo& writer) {
  Writer& followed = writers_[writer.guid];
  followed.recorded = setup_.recorded;
  followed.info = writer;  // its process may have got a name meanwhile
  writer_of_handle_[writer.handle] = &followed;
  read_what_is(writer);
}

void TopicRecording::read_what_is(const wire::EndpointInfo& writer) {
  const Offer offered = offer_of(writer);
  if (readers_.contains(offered)) return;
  const wire::UntypedTopic topic{setup_.kind.topic, setup_.kind.dds_type, setup_.kind.keyed};
  auto reader =
      std::make_unique<wire::Reader>(setup_.participant, topic, asked_of(writer), setup_.depth);
  reader->on_data([this] {
    ready_ = true;
    setup_.on_data();
  });
  readers_.emplace(offered, std::move(reader));
  ready_ = true;  // because messages may have come before the callback was set
  setup_.on_data();
}

bool TopicRecording::hears(const wire::EndpointInfo& writer) const {
  const auto reader = readers_.find(offer_of(writer));
  return reader != readers_.end() && reader->second->matches(writer.handle);
}

void TopicRecording::take(const Receive& receive) {
  if (!ready_.exchange(false)) return;
  for (const auto& [offer, reader] : readers_) take_from(*reader, offer, receive);
}

/// A reader hears the better writers, too, whose own reader hears them as well.
void TopicRecording::take_from(wire::Reader& reader, Offer asked, const Receive& receive) {
  int count = 0;
  std::map<Writer*, std::uint64_t> lost_before;
  reader.take([&](const wire::Received& received) {
    ++count;
    Writer& writer = writer_of(received.writer);
    if (offer_of(writer.info) != asked) return;
    lost_before.try_emplace(&writer, writer.tally.lost());
    // On a topic with keys those messages have numbers, too, that end a key and never get here.
    if (writer.tally.note(setup_.kind.keyed ? 0 : received.sequence)) receive(received, writer);
  });
  if (count < setup_.depth) return;
  for (const auto& [writer, lost] : lost_before) writer->overrun += writer->tally.lost() - lost;
}

TopicRecording::Writer& TopicRecording::writer_of(std::uint64_t handle) {
  const auto known = writer_of_handle_.find(handle);
  if (known != writer_of_handle_.end()) return *known->second;
  const auto found = setup_.find(handle);
  const auto info = found ? *found : writer_that_left(handle);
  Writer& writer = writers_[info.guid];
  writer.info = info;
  writer.recorded = setup_.recorded;
  return *(writer_of_handle_[handle] = &writer);
}

/// It is taken from the reader that asks for least, and taken to define its messages as another
/// writer of the topic does.
wire::EndpointInfo TopicRecording::writer_that_left(std::uint64_t handle) const {
  const Offer weakest = readers_.begin()->first;
  wire::EndpointInfo info;
  if (!writers_.empty()) info.type_hash = writers_.begin()->second.info.type_hash;
  info.writes = true;
  info.topic = setup_.kind.topic;
  info.dds_type = setup_.kind.dds_type;
  info.keyed = setup_.kind.keyed;
  info.process = "a process that left";
  info.qos.reliable = weakest.reliable;
  info.qos.exclusive = setup_.kind.exclusive;
  if (weakest.kept) info.qos.durability = wire::EndpointQos::Durability::kTransientLocal;
  info.handle = handle;
  info.guid = "handle " + std::to_string(handle);
  return info;
}

}  // namespace galilean::monitor
