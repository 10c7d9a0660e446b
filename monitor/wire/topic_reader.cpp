// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/wire/topic_reader.h"

#include <utility>

#include "core/visible_text.h"
#include "core/wire/untyped_topic.h"
#include "monitor/wire/qos_report.h"
#include "monitor/wire/topic_name.h"

namespace galilean::monitor {
namespace {

constexpr int kMessagesKept = 600;

std::string differing_definition(const wire::EndpointInfo& end) {
  return visible(end.process) + "'s definition of " + visible(shown_type(end.dds_type)) +
         " differs from ours: its messages are decoded by its own";
}

}  // namespace

TopicReader::TopicReader(Wire wire, FoundTopic topic, const std::function<void()>& on_data)
    : wire_(wire), topic_(std::move(topic)) {
  std::map<std::pair<std::string, bool>, std::vector<wire::EndpointInfo>> by_type;
  for (const auto& end : topic_.ends) by_type[{end.dds_type, end.keyed}].push_back(end);
  for (const auto& [type, ends] : by_type) {
    const wire::UntypedTopic untyped{topic_.dds_topic, type.first, type.second};
    auto reader =
        std::make_unique<wire::Reader>(wire_.participant, untyped, least_qos(ends), kMessagesKept);
    reader->on_data(on_data);
    readers_.push_back({type.first, type.second, std::move(reader)});
  }
}

void TopicReader::take(const std::function<void(const wire::Received&)>& receive) {
  for (const auto& [dds_type, keyed, reader] : readers_) {
    taken_type_ = dds_type;
    if (!keyed) {
      reader->take(receive);
      continue;
    }
    reader->take([&](wire::Received received) {
      received.sequence = 0;
      receive(received);
    });
  }
}

Result<void> TopicReader::prepare() {
  Result<void> problem;
  for (const auto& end : topic_.ends) {
    auto decoder = decoder_for(end);
    if (decoder)
      decoders_[end.handle] = std::move(decoder).value();
    else if (problem)
      problem = decoder.error();
  }
  return any_.empty() ? problem : Result<void>();
}

Result<MessageTree> TopicReader::decode(const wire::Received& received) {
  auto found = decoders_.find(received.writer);
  if (found == decoders_.end()) {
    auto decoder = decoder_of(received.writer);
    if (!decoder) return decoder.error();
    found = decoders_.emplace(received.writer, std::move(decoder).value()).first;
  }
  return found->second->decode(received.cdr);
}

Result<TopicReader::Decoder> TopicReader::decoder_of(std::uint64_t writer) {
  for (const auto& end : wire_.endpoints.known())
    if (end.handle == writer) return decoder_for(end);
  if (const auto any = any_.find(taken_type_); any != any_.end()) return any->second;
  return Error{"a writer of '" + visible(shown_topic(topic_.dds_topic)) +
               "' left before it told the definition of its messages"};
}

Result<TopicReader::Decoder> TopicReader::decoder_for(const wire::EndpointInfo& end) {
  auto type = wire_.definitions.find(end);
  if (!type) return type.error();
  if (definition_of(end) == Definition::kOther) notes_.push_back(differing_definition(end));
  auto decoder = std::make_shared<const MessageDecoder>(std::move(type).value());
  any_.emplace(end.dds_type, decoder);
  return Result<Decoder>(std::move(decoder));
}

}  // namespace galilean::monitor
