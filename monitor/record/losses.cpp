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
  "description": "What this recording lacks of what one writer sent on one topic, until now.",
  "type": "object",
  "properties": {
    "topic": {"type": "string"},
    "process": {"type": "string", "description": "the name of the writer's process, or its GUID"},
    "recorded": {"type": "integer", "description": "messages in this recording"},
    "missing": {"type": ["integer", "null"], "description": "sent between the first and the last that came; null: unknown"},
    "sent_before": {"type": "integer", "description": "sent before the first that came"},
    "unwritten": {"type": "integer", "description": "came while there was no room to write them"}
  }
})";

nlohmann::ordered_json json_of(const WriterLosses& losses) {
  return {
      {"topic", losses.topic},
      {"process", losses.process},
      {"recorded", losses.recorded},
      {"missing", losses.lost ? nlohmann::ordered_json(*losses.lost) : nlohmann::ordered_json()},
      {"sent_before", losses.sent_before}};
}

}  // namespace

std::uint64_t total_missing(const std::vector<WriterLosses>& losses) noexcept {
  return std::accumulate(
      losses.begin(), losses.end(), std::uint64_t{0},
      [](std::uint64_t sum, const WriterLosses& each) { return sum + each.lost.value_or(0) + each.unwritten; });
}

Result<void> LossLog::tell(const std::vector<WriterLosses>& losses, std::int64_t now_ns) {
  for (const auto& each : losses) {
    const bool is_told = std::ranges::any_of(told_, [&](const WriterLosses& told) {
      return told.topic == each.topic && told.process == each.process && told.lost == each.lost &&
             told.unwritten == each.unwritten;
    });
    if ((each.lost.value_or(0) == 0 && each.unwritten == 0) || is_told) continue;
    if (channel_ == 0)
      channel_ = writer_.add_channel(
          {.schema_id = writer_.add_schema("galilean.Losses", "jsonschema", kLossesSchema),
           .topic = "/recorder/losses",
           .message_encoding = "json",
           .metadata = {}});
    const std::string text = ordered_json_text(json_of(each));
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(text.data());
    const auto time_ns = static_cast<std::uint64_t>(now_ns);
    if (auto done = writer_.write({channel_, ++sequence_, time_ns, time_ns, {bytes, text.size()}});
        !done)
      return done;
  }
  told_ = losses;
  return {};
}

Result<void> LossLog::conclude(const std::vector<WriterLosses>& losses) {
  mcap::Metadata all{"losses", {}};
  for (const auto& each : losses)
    if (each.lost != 0 || each.sent_before > 0 || each.unwritten > 0)
      all.entries[each.topic + " of " + each.process] = ordered_json_text(json_of(each));
  all.entries["missing"] = std::to_string(total_missing(losses));
  return writer_.write(all);
}

}  // namespace galilean::monitor
