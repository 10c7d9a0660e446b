// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/log_info.h"

#include <algorithm>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

#include "core/json_text.h"
#include "core/plural.h"
#include "core/visible_text.h"
#include "monitor/record/times.h"

namespace galilean::monitor {
namespace {

struct Row {
  std::string topic, type;
  std::uint64_t messages;
  double rate_hz;
};

std::vector<Row> rows(const mcap::Summary& summary) {
  std::vector<Row> result;
  for (const auto& [id, channel] : summary.channels) {
    const auto count = summary.statistics.channel_messages.find(id);
    const auto messages = count == summary.statistics.channel_messages.end() ? 0 : count->second;
    const auto schema = summary.schemas.find(channel.schema_id);
    const double span_s = duration_s(summary);
    result.push_back({channel.topic, schema == summary.schemas.end() ? "" : schema->second.name,
                      messages, span_s > 0 ? static_cast<double>(messages) / span_s : 0});
  }
  std::sort(result.begin(), result.end(),
            [](const Row& a, const Row& b) { return a.topic < b.topic; });
  return result;
}

std::string compression(const mcap::Summary& summary) {
  std::string names;
  for (const auto& [name, chunks] : summary.compressions)
    names += (names.empty() ? "" : ", ") + (name.empty() ? "none" : name);
  return names.empty() ? "none" : names;
}

std::string missing_line(const ToldLosses& losses) {
  const auto missing = plural(total_missing(losses.writers), "message");
  if (losses.is_whole) return missing;
  return "at least " + missing + ", as far as was told before the recorder broke off";
}

void describe_losses(std::ostream& out, const std::optional<ToldLosses>& losses) {
  out << "missing:   " << (losses ? missing_line(*losses) : "unknown; its recorder did not count")
      << '\n';
  if (!losses) return;
  for (const auto& each : losses->writers) {
    out << "  " << visible(each.topic) << " of " << visible(each.process) << ": "
        << (each.lost ? std::to_string(*each.lost) : "unknown") << " lost, " << each.overrun
        << " of them because the recorder was too slow, " << each.sent_before << " sent before";
    if (each.unwritten > 0) out << ", " << each.unwritten << " not written for want of room";
    if (each.left_out > 0) out << ", " << each.left_out << " left out as was asked";
    out << '\n';
  }
}

nlohmann::ordered_json losses_json(const std::optional<ToldLosses>& losses) {
  if (!losses) return nullptr;
  auto writers = nlohmann::ordered_json::array();
  for (const auto& each : losses->writers) writers.push_back(json_of(each));
  return {{"missing", total_missing(losses->writers)},
          {"complete", losses->is_whole},
          {"writers", std::move(writers)}};
}

void describe_channels(std::ostream& out, const mcap::Summary& summary) {
  auto all = rows(summary);
  std::size_t widest = 5;
  for (auto& row : all) {
    row.topic = visible(row.topic);
    widest = std::max(widest, row.topic.size());
  }
  for (const auto& row : all)
    out << "  " << std::left << std::setw(static_cast<int>(widest)) << row.topic << std::right
        << std::setw(9) << row.messages << std::setw(8) << row.rate_hz << " Hz  "
        << visible(row.type) << '\n';
}

}  // namespace

double duration_s(const mcap::Summary& summary) {
  return static_cast<double>(summary.statistics.end_ns - summary.statistics.start_ns) * 1e-9;
}

std::string describe(const std::string& path, const mcap::Summary& summary,
                     const std::optional<ToldLosses>& losses) {
  const auto& statistics = summary.statistics;
  std::ostringstream out;
  out << std::fixed << std::setprecision(1);
  if (summary.recovered)
    out << path << " was not closed properly; recovered " << plural(statistics.messages, "message")
        << "\n";
  for (const auto& damage : summary.damage) out << "damage: " << visible(damage) << '\n';
  out << "file:      " << path << ", " << static_cast<double>(summary.bytes) * 1e-6 << " MB\n"
      << "by:        " << visible(summary.header.library) << ", profile "
      << visible(summary.header.profile) << '\n';
  if (statistics.messages > 0)
    out << "from:      " << iso_time(static_cast<std::int64_t>(statistics.start_ns)) << '\n'
        << "to:        " << iso_time(static_cast<std::int64_t>(statistics.end_ns)) << '\n';
  out << "duration:  " << duration_s(summary) << " s\n"
      << "messages:  " << statistics.messages << '\n'
      << "chunks:    " << statistics.chunks << ", compression " << visible(compression(summary))
      << '\n'
      << "channels:  " << summary.channels.size() << '\n';
  describe_channels(out, summary);
  describe_losses(out, losses);
  for (const auto& name : summary.attachments) out << "attached:  " << visible(name) << '\n';
  return out.str();
}

std::string describe_json(const std::string& path, const mcap::Summary& summary,
                          const std::optional<ToldLosses>& losses) {
  const auto& statistics = summary.statistics;
  nlohmann::ordered_json json{{"file", path},
                              {"bytes", summary.bytes},
                              {"library", summary.header.library},
                              {"profile", summary.header.profile},
                              {"start", iso_time(static_cast<std::int64_t>(statistics.start_ns))},
                              {"end", iso_time(static_cast<std::int64_t>(statistics.end_ns))},
                              {"duration_seconds", duration_s(summary)},
                              {"messages", statistics.messages},
                              {"chunks", statistics.chunks},
                              {"compression", compression(summary)},
                              {"recovered", summary.recovered},
                              {"damage", summary.damage},
                              {"losses", losses_json(losses)},
                              {"attachments", summary.attachments},
                              {"channels", nlohmann::ordered_json::array()},
                              {"metadata", nlohmann::ordered_json::object()}};
  for (const auto& row : rows(summary))
    json["channels"].push_back({{"topic", row.topic},
                                {"type", row.type},
                                {"messages", row.messages},
                                {"rate_hz", row.rate_hz}});
  for (const auto& metadata : summary.metadata) json["metadata"][metadata.name] = metadata.entries;
  return ordered_json_text(json, 2) + "\n";
}

}  // namespace galilean::monitor
