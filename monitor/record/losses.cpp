// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/losses.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>

#include "core/json_text.h"

namespace galilean::monitor {
namespace {

constexpr const char* kLossesSchema = R"({
  "title": "galilean.Losses",
  "description": "What a recording lacks of what one writer sent on one topic, since it began and until now.",
  "type": "object",
  "properties": {
    "topic": {"type": "string"},
    "process": {"type": "string", "description": "the name of the writer's process, or its GUID"},
    "writer": {"type": "string", "description": "the writer's own GUID"},
    "recorded": {"type": "integer", "description": "messages in the recording"},
    "filled": {"type": "integer", "description": "of these: events of a robot that came late, and fill a gap in which it was not heard"},
    "not_received": {"type": ["integer", "null"], "description": "sent between the first and the last that came; null: unknown"},
    "overrun": {"type": "integer", "description": "of these: missed while the recorder's own queue was full"},
    "sent_before": {"type": "integer", "description": "sent before the first that came"},
    "unwritten": {"type": "integer", "description": "came while there was no room to write them"},
    "left_out": {"type": "integer", "description": "pictures beyond the bytes a second that were asked for; not missing"},
    "paused": {"type": "integer", "description": "sent while the recording was paused; not missing"}
  }
})";

std::uint64_t number_in(const nlohmann::json& json, const char* name) {
  const auto found = json.find(name);
  return found != json.end() && found->is_number_unsigned() ? found->get<std::uint64_t>() : 0;
}

std::string text_in(const nlohmann::json& json, const char* name) {
  const auto found = json.find(name);
  return found != json.end() && found->is_string() ? found->get<std::string>() : "";
}

/// Returns what is told while it records, each time that it has grown.
std::uint64_t told_of(const WriterLosses& losses) noexcept {
  return losses.missing() + losses.filled;
}

std::uint64_t beyond(std::uint64_t count, std::uint64_t before) noexcept {
  return count - std::min(count, before);
}

}  // namespace

std::uint64_t total_missing(const std::vector<WriterLosses>& losses) noexcept {
  return std::accumulate(
      losses.begin(), losses.end(), std::uint64_t{0},
      [](std::uint64_t sum, const WriterLosses& each) { return sum + each.missing(); });
}

nlohmann::ordered_json json_of(const WriterLosses& losses) {
  const nlohmann::ordered_json lost = losses.lost ? nlohmann::ordered_json(*losses.lost) : nullptr;
  return {{"topic", losses.topic},         {"process", losses.process},
          {"writer", losses.writer},       {"recorded", losses.recorded},
          {"filled", losses.filled},       {"not_received", lost},
          {"overrun", losses.overrun},     {"sent_before", losses.sent_before},
          {"unwritten", losses.unwritten}, {"left_out", losses.left_out},
          {"paused", losses.paused}};
}

std::optional<WriterLosses> read_losses(std::string_view text) {
  const auto read = read_untrusted_json(text);
  if (!read || !read.value().is_object() || !read.value().contains("recorded")) return std::nullopt;
  const auto& json = read.value();
  WriterLosses losses{.topic = text_in(json, "topic"),
                      .process = text_in(json, "process"),
                      .writer = text_in(json, "writer"),
                      .recorded = number_in(json, "recorded"),
                      .filled = number_in(json, "filled"),
                      .lost = number_in(json, "not_received"),
                      .overrun = number_in(json, "overrun"),
                      .sent_before = number_in(json, "sent_before"),
                      .unwritten = number_in(json, "unwritten"),
                      .left_out = number_in(json, "left_out"),
                      .paused = number_in(json, "paused")};
  if (json.contains("not_received") && json["not_received"].is_null()) losses.lost = std::nullopt;
  return losses;
}

WriterLosses beyond(WriterLosses losses, const WriterLosses& before) noexcept {
  losses.recorded = beyond(losses.recorded, before.recorded);
  losses.filled = beyond(losses.filled, before.filled);
  if (losses.lost) losses.lost = beyond(*losses.lost, before.lost.value_or(0));
  losses.overrun = beyond(losses.overrun, before.overrun);
  losses.sent_before = beyond(losses.sent_before, before.sent_before);
  losses.unwritten = beyond(losses.unwritten, before.unwritten);
  losses.left_out = beyond(losses.left_out, before.left_out);
  losses.paused = beyond(losses.paused, before.paused);
  return losses;
}

mcap::Metadata losses_metadata(const char* name, const std::vector<WriterLosses>& losses) {
  mcap::Metadata all{name, {}};
  for (const auto& each : losses) {
    const std::string whose = each.topic + " of " + each.process;
    const bool is_taken = all.entries.contains(whose);
    all.entries[is_taken ? whose + " (" + each.writer + ")" : whose] =
        ordered_json_text(json_of(each));
  }
  all.entries["missing"] = std::to_string(total_missing(losses));
  return all;
}

Result<void> LossLog::begin(const std::vector<WriterLosses>& before) {
  for (const auto& each : before) told_[each.writer] = told_of(each);
  return writer_.write(losses_metadata(kLossesBeforeMetadata, before));
}

Result<void> LossLog::tell(const std::vector<WriterLosses>& losses, std::int64_t now_ns) {
  for (const auto& each : losses) {
    if (told_of(each) == told_[each.writer]) continue;
    if (auto done = write(each, now_ns); !done) return done;
    told_[each.writer] = told_of(each);
  }
  return {};
}

Result<void> LossLog::write(const WriterLosses& losses, std::int64_t now_ns) {
  if (channel_ == 0)
    channel_ = writer_.add_channel(
        {.schema_id = writer_.add_schema("galilean.Losses", "jsonschema", kLossesSchema),
         .topic = kLossesTopic,
         .message_encoding = "json",
         .metadata = {}});
  const std::string text = ordered_json_text(json_of(losses));
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(text.data());
  const auto time_ns = static_cast<std::uint64_t>(now_ns);
  return writer_.write({channel_, ++sequence_, time_ns, time_ns, {bytes, text.size()}});
}

Result<void> LossLog::conclude(const std::vector<WriterLosses>& losses) {
  return writer_.write(losses_metadata(kLossesMetadata, losses));
}

}  // namespace galilean::monitor
