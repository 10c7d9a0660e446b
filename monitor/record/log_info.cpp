// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/log_info.h"

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <tuple>
#include <utility>

#include "core/plural.h"
#include "core/visible_text.h"
#include "monitor/record/channel_metadata.h"
#include "monitor/record/damage_text.h"
#include "monitor/record/program_changes.h"
#include "monitor/record/recording_report.h"
#include "monitor/record/times.h"

namespace galilean::monitor {
namespace {

/// A longer name of a topic reaches into the next columns.
constexpr std::size_t kWidestTopic = 48;
/// As much of a program's hash as tells programs apart for people.
constexpr std::size_t kShownOfHash = 12;

struct Row {
  std::string topic, type;
  std::string process;  ///< of the writer whose channel it is; empty: several, or unknown
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
    const auto process = channel.metadata.find(kChannelProcess);
    result.push_back({channel.topic, schema == summary.schemas.end() ? "" : schema->second.name,
                      process == channel.metadata.end() ? "" : process->second, messages,
                      span_s > 0 ? static_cast<double>(messages) / span_s : 0});
  }
  std::ranges::sort(result, {}, [](const Row& row) { return std::tie(row.topic, row.process); });
  return result;
}

std::string missing_line(const ToldLosses& losses) {
  const auto missing = plural(losses.missing(), "message");
  if (losses.is_whole) return missing;
  return "at least " + missing +
         (losses.copies.empty() ? ", as far as was told before the recorder broke off"
                                : ", as far as is known");
}

void describe_losses(std::ostream& out, const std::optional<ToldLosses>& losses) {
  out << "missing:   " << (losses ? missing_line(*losses) : "unknown; nothing in the file tells it")
      << '\n';
  if (!losses) return;
  for (const auto& each : losses->writers)
    out << "  " << visible(each.topic) << " of " << visible(each.process) << ": "
        << losses_text(each) << '\n';
  for (const auto& copy : losses->copies) out << "  " << copy_loss_text(copy) << '\n';
}

void describe_channels(std::ostream& out, const mcap::Summary& summary) {
  auto all = rows(summary);
  std::size_t widest = 5;
  for (auto& row : all) {
    row.topic = visible(row.topic);
    widest = std::min(std::max(widest, row.topic.size()), kWidestTopic);
  }
  for (const auto& row : all)
    out << "  " << std::left << std::setw(static_cast<int>(widest)) << row.topic << std::right
        << std::setw(9) << row.messages << std::setw(8) << row.rate_hz << " Hz  "
        << visible(row.type) << (row.process.empty() ? "" : " of " + visible(row.process)) << '\n';
}

std::string value_in(const mcap::Metadata& metadata, const std::string& name) {
  const auto found = metadata.entries.find(name);
  return found == metadata.entries.end() ? "?" : visible(found->second);
}

/// Returns the metadata that tells who recorded, as "host lab3, seed 7, …".
std::string about_text(const mcap::Metadata& metadata) {
  std::string text;
  for (const auto& [name, value] : metadata.entries)
    text += (text.empty() ? "" : ", ") + visible(name) + ' ' + visible(value);
  return text;
}

void describe_extras(std::ostream& out, const mcap::Summary& summary) {
  for (const auto& metadata : summary.metadata)
    if (metadata.name == kRecorderMetadata)
      out << "recorder:  " << about_text(metadata) << '\n';
    else if (metadata.name == kProgramMetadata)
      out << "program:   " << value_in(metadata, "robot") << " ran " << value_in(metadata, "name")
          << ' ' << value_in(metadata, "hash").substr(0, kShownOfHash) << " from "
          << value_in(metadata, "since") << '\n';
    else
      out << "metadata:  " << visible(metadata.name) << ", "
          << plural(metadata.entries.size(), "value") << '\n';
  for (const auto& attachment : summary.attachments)
    out << "attached:  " << visible(attachment.name) << ", " << visible(attachment.media_type)
        << ", " << plural(attachment.data_bytes, "byte") << '\n';
}

}  // namespace

std::string compression_text(const mcap::Summary& summary) {
  std::string names;
  for (const auto& [name, chunks] : summary.compressions)
    names += (names.empty() ? "" : ", ") + (name.empty() ? "none" : name);
  return names.empty() ? "none" : names;
}

double duration_s(const mcap::Summary& summary) {
  std::uint64_t span_ns = summary.statistics.end_ns - summary.statistics.start_ns;
  for (const auto& silence : summary.silences) span_ns -= silence.end_ns - silence.start_ns;
  return static_cast<double>(span_ns) * 1e-9;
}

std::string describe(const std::string& path, const mcap::Summary& summary,
                     const std::optional<ToldLosses>& losses, const std::vector<Pause>& pauses) {
  const auto& statistics = summary.statistics;
  std::ostringstream out;
  out << std::fixed << std::setprecision(1);
  out << condition_text(path, summary);
  out << "file:      " << path << ", " << static_cast<double>(summary.bytes) * 1e-6 << " MB\n"
      << "by:        " << visible(summary.header.library) << ", profile "
      << visible(summary.header.profile) << '\n';
  if (statistics.messages > 0)
    out << "from:      " << iso_time(statistics.start_ns) << '\n'
        << "to:        " << iso_time(statistics.end_ns) << '\n';
  out << "duration:  " << duration_s(summary) << " s\n"
      << "messages:  " << statistics.messages << '\n'
      << "chunks:    " << statistics.chunks << ", compression "
      << visible(compression_text(summary)) << '\n'
      << "checked:   "
      << (summary.checked ? "every message and checksum"
                          : "what stands where; --check reads every message")
      << '\n'
      << "channels:  " << summary.channels.size() << '\n';
  describe_channels(out, summary);
  describe_losses(out, losses);
  for (const auto& pause : pauses) out << "pause:     " << pause_text(pause) << '\n';
  describe_extras(out, summary);
  return out.str();
}

}  // namespace galilean::monitor
