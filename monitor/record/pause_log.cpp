// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/pause_log.h"

#include <charconv>
#include <nlohmann/json.hpp>

#include "core/json_text.h"
#include "core/plural.h"
#include "core/visible_text.h"
#include "monitor/record/times.h"

namespace galilean::monitor {
namespace {

constexpr const char* kPauseSchema = R"({
  "title": "galilean.Pause",
  "description": "A time in which the recorder was paused. What came then was not recorded, and is not missing.",
  "type": "object",
  "properties": {
    "from": {"type": "string", "description": "ISO 8601"},
    "from_ns": {"type": "string", "description": "nanoseconds since the Unix epoch"},
    "to": {"type": ["string", "null"], "description": "null: it has not ended yet"},
    "to_ns": {"type": ["string", "null"]},
    "messages": {"type": "integer", "description": "messages that came meanwhile"},
    "by": {"type": "string", "description": "who asked for it"}
  }
})";

/// Times need 64 bits, which a number in JSON does not have everywhere: they are texts.
std::optional<std::int64_t> time_in(const nlohmann::json& json, const char* name) {
  const auto found = json.find(name);
  if (found == json.end() || !found->is_string()) return std::nullopt;
  const auto& text = found->get_ref<const std::string&>();
  std::int64_t time_ns = 0;
  const auto* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, time_ns);
  if (read.ec != std::errc() || read.ptr != end || time_ns < 0) return std::nullopt;
  return time_ns;
}

std::string iso_of(std::int64_t time_ns) {
  return iso_time(static_cast<std::uint64_t>(time_ns));
}

}  // namespace

nlohmann::ordered_json json_of(const Pause& pause) {
  nlohmann::ordered_json json{{"from", iso_of(pause.from_ns)},
                              {"from_ns", std::to_string(pause.from_ns)},
                              {"to", nullptr},
                              {"to_ns", nullptr},
                              {"messages", pause.messages},
                              {"by", pause.by}};
  if (pause.to_ns) {
    json["to"] = iso_of(*pause.to_ns);
    json["to_ns"] = std::to_string(*pause.to_ns);
  }
  return json;
}

std::optional<Pause> read_pause(std::string_view text) {
  const auto read = read_untrusted_json(text);
  if (!read || !read.value().is_object()) return std::nullopt;
  const auto& json = read.value();
  const auto from_ns = time_in(json, "from_ns");
  if (!from_ns) return std::nullopt;
  Pause pause{.from_ns = *from_ns, .to_ns = time_in(json, "to_ns"), .messages = 0, .by = {}};
  const auto messages = json.find("messages"), by = json.find("by");
  if (messages != json.end() && messages->is_number_unsigned())
    pause.messages = messages->get<std::uint64_t>();
  if (by != json.end() && by->is_string()) pause.by = by->get<std::string>();
  return pause;
}

std::string pause_text(const Pause& pause) {
  std::string text = "paused";
  if (!pause.by.empty()) text += " by " + visible(pause.by);
  text += " from " + iso_of(pause.from_ns);
  if (!pause.to_ns) return text + " on";
  const double span_s = static_cast<double>(*pause.to_ns - pause.from_ns) * 1e-9;
  return text + " to " + iso_of(*pause.to_ns) + " (" + time_span(span_s) + "), " +
         plural(pause.messages, "message") + " not recorded";
}

Result<void> PauseLog::tell(const Pause& pause) {
  if (pauses_.empty() || pauses_.back().from_ns != pause.from_ns || pauses_.back().to_ns)
    pauses_.push_back(pause);
  else
    pauses_.back() = pause;
  if (channel_ == 0)
    channel_ = writer_.add_channel(
        {.schema_id = writer_.add_schema("galilean.Pause", "jsonschema", kPauseSchema),
         .topic = kPausesTopic,
         .message_encoding = "json",
         .metadata = {}});
  const std::string text = ordered_json_text(json_of(pause));
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(text.data());
  const auto time_ns = static_cast<std::uint64_t>(pause.to_ns.value_or(pause.from_ns));
  return writer_.write({channel_, ++sequence_, time_ns, time_ns, {bytes, text.size()}});
}

Result<void> PauseLog::conclude() {
  if (pauses_.empty()) return {};
  mcap::Metadata all{kPausesMetadata, {}};
  for (const auto& pause : pauses_)
    all.entries[std::to_string(all.entries.size() + 1)] = ordered_json_text(json_of(pause));
  return writer_.write(all);
}

}  // namespace galilean::monitor
