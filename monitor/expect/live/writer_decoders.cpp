// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/live/writer_decoders.h"

#include "core/visible_text.h"
#include "monitor/wire/topic_name.h"

namespace galilean::expect {
namespace {

constexpr std::size_t kMostWays = 10'000;

/// Returns whether a writer has this release's definition of its type, as far as it says.
bool is_ours(const wire::EndpointInfo& writer) {
  const auto definition = monitor::definition_of(writer);
  return definition == monitor::Definition::kOurs ||
         definition == monitor::Definition::kUnpublished;
}

}  // namespace

bool WriterDecoders::wants(const wire::EndpointInfo& writer) const {
  const auto topic = monitor::shown_topic(writer.topic);
  return sink_.wants_messages(topic) || sink_.wants_fields(topic) ||
         sink_.wants_type(monitor::shown_type(writer.dds_type));
}

bool WriterDecoders::take(std::int64_t at_ns, const wire::EndpointInfo& writer,
                          const wire::Received& received) {
  auto known = ways_.find(writer.guid);
  if (known == ways_.end()) {
    if (ways_.size() == kMostWays) ways_.clear();
    known = ways_.emplace(writer.guid, way_of(writer)).first;
  }
  const Way& way = known->second;
  // What ends a key has a number, too, and is no message.
  if (way.counted)
    sink_.message(at_ns, way.topic, {way.writer, writer.keyed ? 0 : received.sequence});
  const bool typed = !way.typed || (typed_.*way.typed)(at_ns, received.cdr);
  if (!way.fields_wanted) return typed;
  if (!way.fields) return false;
  const auto fields = way.fields->decode(received.cdr);
  if (fields) sink_.fields(at_ns, way.topic, fields.value());
  return typed && fields;
}

WriterDecoders::Way WriterDecoders::way_of(const wire::EndpointInfo& writer) {
  Way way{.writer = ++writers_, .topic = monitor::shown_topic(writer.topic)};
  const auto type = monitor::shown_type(writer.dds_type);
  way.counted = sink_.wants_messages(way.topic);
  if (sink_.wants_type(type)) {
    if (is_ours(writer))
      way.typed = TypedDecoder::function_for(type);
    else
      notes_.push_back(visible(way.topic) + " is not judged: its writer defines " + visible(type) +
                       " otherwise than this release");
  }
  way.fields_wanted = sink_.wants_fields(way.topic);
  if (!way.fields_wanted) return way;
  if (auto found = definitions_.find(writer))
    way.fields.emplace(std::move(found).value());
  else
    notes_.push_back(found.error().message);
  return way;
}

}  // namespace galilean::expect
