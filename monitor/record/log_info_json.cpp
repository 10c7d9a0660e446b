// SPDX-License-Identifier: BSD-3-Clause
#include <nlohmann/json.hpp>
#include <utility>

#include "core/json_text.h"
#include "monitor/record/damage_text.h"
#include "monitor/record/log_info.h"
#include "monitor/record/times.h"

namespace galilean::monitor {
namespace {

using Json = nlohmann::ordered_json;

std::uint64_t count_of(const mcap::Summary& summary, std::uint16_t channel) {
  const auto found = summary.statistics.channel_messages.find(channel);
  return found == summary.statistics.channel_messages.end() ? 0 : found->second;
}

/// Times need 64 bits, which a number in JSON does not have everywhere: they are texts.
void add_time(Json& to, const std::string& name, std::uint64_t time_ns) {
  to[name] = iso_time(time_ns);
  to[name + "_ns"] = std::to_string(time_ns);
}

Json topics_json(const std::map<std::uint16_t, std::uint64_t>& counts,
                 const mcap::Summary& summary) {
  auto topics = Json::object();
  for (const auto& [channel, messages] : counts) {
    auto& count = topics[topic_of(channel, summary)];
    count = (count.is_null() ? 0 : count.get<std::uint64_t>()) + messages;
  }
  return topics;
}

Json damage_json(const mcap::Damage& damage, const mcap::Summary& summary) {
  Json json{{"what", damage.what},
            {"byte", damage.offset},
            {"messages", damage.messages ? Json(*damage.messages) : Json()}};
  if (damage.time) {
    add_time(json, "start", damage.time->start_ns);
    add_time(json, "end", damage.time->end_ns);
  }
  json["topics"] = topics_json(damage.channel_messages, summary);
  return json;
}

Json copy_json(const CopyLosses& losses) {
  return {{"file", losses.file},
          {"missing", losses.missing()},
          {"exact", losses.is_exact},
          {"topics", losses.topics},
          {"others", losses.others}};
}

Json losses_json(const std::optional<ToldLosses>& losses) {
  if (!losses) return nullptr;
  auto writers = Json::array();
  for (const auto& each : losses->writers) writers.push_back(json_of(each));
  auto copies = Json::array();
  for (const auto& each : losses->copies) copies.push_back(copy_json(each));
  return {{"missing", losses->missing()},
          {"complete", losses->is_whole},
          {"writers", std::move(writers)},
          {"copies", std::move(copies)}};
}

Json lost_json(const mcap::Summary& summary) {
  std::uint64_t messages = 0;
  for (const auto& [channel, count] : summary.lost) messages += count;
  return {{"messages", messages},
          {"exact", summary.lost_is_exact},
          {"topics", topics_json(summary.lost, summary)}};
}

/// Returns the bytes as text if they are UTF-8, else in hexadecimal digits.
Json data_json(const std::string& data) {
  Json json;
  const auto again = read_json(ordered_json_text(Json(data)));
  if (again.ok() && again.value() == data) {
    json["text"] = data;
    return json;
  }
  std::string digits;
  for (const unsigned char byte : data)
    for (const int half : {byte >> 4, byte & 15}) digits += "0123456789abcdef"[half];
  json["hex"] = digits;
  return json;
}

Json channel_json(const mcap::Channel& channel, const mcap::Summary& summary) {
  const double span_s = duration_s(summary);
  const auto schema = summary.schemas.find(channel.schema_id);
  const auto messages = count_of(summary, channel.id);
  return {{"topic", channel.topic},
          {"type", schema == summary.schemas.end() ? "" : schema->second.name},
          {"messages", messages},
          {"rate_hz", span_s > 0 ? static_cast<double>(messages) / span_s : 0},
          {"id", channel.id},
          {"schema_id", channel.schema_id},
          {"message_encoding", channel.message_encoding},
          {"metadata", channel.metadata}};
}

Json channels_json(const mcap::Summary& summary) {
  std::multimap<std::string, const mcap::Channel*> by_topic;
  for (const auto& [id, channel] : summary.channels) by_topic.emplace(channel.topic, &channel);
  auto json = Json::array();
  for (const auto& [topic, channel] : by_topic) json.push_back(channel_json(*channel, summary));
  return json;
}

Json schemas_json(const mcap::Summary& summary) {
  auto json = Json::array();
  for (const auto& [id, schema] : summary.schemas)
    json.push_back({{"id", id},
                    {"name", schema.name},
                    {"encoding", schema.encoding},
                    {"bytes", schema.data.size()},
                    {"data", data_json(schema.data)}});
  return json;
}

Json attachments_json(const mcap::Summary& summary) {
  auto json = Json::array();
  for (const auto& attachment : summary.attachments) {
    Json each{{"name", attachment.name},
              {"media_type", attachment.media_type},
              {"bytes", attachment.data_bytes}};
    add_time(each, "logged", attachment.log_ns);
    add_time(each, "created", attachment.create_ns);
    json.push_back(std::move(each));
  }
  return json;
}

Json silences_json(const mcap::Summary& summary) {
  auto json = Json::array();
  for (const auto& silence : summary.silences) {
    Json each = Json::object();
    add_time(each, "start", silence.start_ns);
    add_time(each, "end", silence.end_ns);
    json.push_back(std::move(each));
  }
  return json;
}

/// Metadata records of one name may stand in a file several times, so they are a list, too.
Json metadata_records_json(const mcap::Summary& summary) {
  auto json = Json::array();
  for (const auto& metadata : summary.metadata)
    json.push_back({{"name", metadata.name}, {"entries", metadata.entries}});
  return json;
}

}  // namespace

std::string describe_json(const std::string& path, const mcap::Summary& summary,
                          const std::optional<ToldLosses>& losses,
                          const std::vector<Pause>& pauses) {
  const auto& statistics = summary.statistics;
  Json json{{"file", path},
            {"bytes", summary.bytes},
            {"library", summary.header.library},
            {"profile", summary.header.profile}};
  add_time(json, "start", statistics.start_ns);
  add_time(json, "end", statistics.end_ns);
  json["duration_seconds"] = duration_s(summary);
  json["messages"] = statistics.messages;
  json["chunks"] = statistics.chunks;
  json["compression"] = compression_text(summary);
  json["closed"] = summary.closed;
  json["being_written"] = summary.being_written;
  json["checked"] = summary.checked;
  json["recovered"] = summary.recovered();
  json["damage"] = Json::array();
  for (const auto& damage : summary.damages) json["damage"].push_back(damage_json(damage, summary));
  json["lost"] = lost_json(summary);
  json["losses"] = losses_json(losses);
  json["pauses"] = Json::array();
  for (const auto& pause : pauses) json["pauses"].push_back(json_of(pause));
  json["silences"] = silences_json(summary);
  json["channels"] = channels_json(summary);
  json["schemas"] = schemas_json(summary);
  json["attachments"] = attachments_json(summary);
  json["metadata"] = Json::object();
  for (const auto& metadata : summary.metadata) json["metadata"][metadata.name] = metadata.entries;
  json["metadata_records"] = metadata_records_json(summary);
  return ordered_json_text(json, 2) + "\n";
}

}  // namespace galilean::monitor
