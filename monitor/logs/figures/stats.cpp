// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/figures/stats.h"

#include <algorithm>
#include <cstdio>
#include <iostream>

#include "core/command_line/exit_code.h"
#include "core/json_text.h"
#include "core/visible_text.h"
#include "monitor/logs/figures/topic_statistics.h"
#include "monitor/logs/reading/undecoded.h"
#include "monitor/record/channel_metadata.h"
#include "monitor/record/copy_losses.h"
#include "monitor/record/damage_text.h"
#include "monitor/record/told_losses.h"
#include "monitor/wire/message_text.h"

namespace galilean::logs {
namespace {

using Json = monitor::MessageTree;

constexpr const char* kStats = "galilean log stats";
constexpr std::size_t kWidestName = 48;

int fail_stats(const std::string& sentence) {
  std::cerr << kStats << ": " << sentence << '\n';
  return kFailed;
}

/// Returns a figure with four digits that count; "-" for one that is not known.
std::string cell(const Json& figure) {
  if (figure.is_null()) return "-";
  if (figure.is_number_integer()) return ordered_json_text(figure);
  char text[48];
  std::snprintf(text, sizeof text, "%.4g", figure.get<double>());
  return text;
}
std::string cell(const Json& figures, const char* name) {
  return figures.is_null() ? "-" : cell(figures[name]);
}

std::string padded(const std::string& text, std::size_t width, bool left) {
  const std::string blanks(text.size() < width ? width - text.size() : 0, ' ');
  return left ? text + blanks : blanks + text;
}

/// Prints rows with columns that are as wide as their widest cell.
void print_table(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  widths[0] = std::min(widths[0], kWidestName);
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i)
      std::cout << padded(row[i], widths[i], i == 0) << (i + 1 == row.size() ? "\n" : "  ");
}

void print_topics(const std::map<std::string, TopicStatistics>& topics) {
  std::vector<std::vector<std::string>> rows{{"topic", "messages", "Hz", "gap s", "to", "deviation",
                                              "bytes", "bytes/s", "delay s", "to", "missing"}};
  for (const auto& [name, statistics] : topics) {
    const auto all = statistics.figures();
    const auto &gap = all["gap_s"], &delay = all["delay_s"];
    rows.push_back({visible(name), cell(all["messages"]), cell(all["rate_hz"]), cell(gap, "least"),
                    cell(gap, "most"), cell(gap, "deviation"), cell(all["bytes"]),
                    cell(all["bytes_per_s"]), cell(delay, "least"), cell(delay, "most"),
                    cell(all["missing"])});
  }
  print_table(rows);
}

class Statistics {
 public:
  Statistics(const Recording& recording, const StatsOptions& options)
      : recording_(recording), options_(options), trees_(recording.summary()), undecoded_(kStats) {}

  /// Errors: a message has no field as asked for.
  Result<void> add(const mcap::Message& message, double at_s) {
    const std::string topic = monitor::topic_of(message.channel_id, recording_.summary());
    topics_[topic].add(message, at_s, is_numbered(message.channel_id));
    if (options_.fields.empty()) return {};
    const auto tree = trees_.decode(message);
    if (!tree) return undecoded_.add(topic, tree.error().message), Result<void>();
    for (const auto& name : options_.fields) {
      const auto field = monitor::find_field(tree.value(), name);
      if (!field) return Error{"in messages of " + visible(topic) + " " + field.error().message};
      if (field.value()) fields_[name].add(at_s, *field.value());
    }
    return {};
  }

  /// Takes what the recorder counted as missing of the whole recording.
  void take(const monitor::ToldLosses& losses) {
    const auto missing = monitor::missing_by_topic(losses, recording_.summary());
    for (auto& [topic, statistics] : topics_)
      if (const auto told = missing.find(visible(topic)); told != missing.end())
        statistics.set_missing(told->second);
  }

  /// Takes what is lost by damage of the whole recording, and of those that it was copied from.
  void take(const std::vector<mcap::Damage>& damages) {
    const auto& summary = recording_.summary();
    std::map<std::string, std::uint64_t> lost;
    for (const auto& [channel, messages] : monitor::lost_by_channel(summary, damages))
      lost[monitor::topic_of(channel, summary)] += messages;
    for (const auto& copy : monitor::copy_losses(summary))
      for (const auto& [topic, messages] : copy.topics) lost[topic] += messages;
    for (auto& [topic, statistics] : topics_)
      if (const auto found = lost.find(topic); found != lost.end())
        statistics.add_damaged(found->second);
  }

  [[nodiscard]] int print() const {
    if (options_.json)
      print_json();
    else
      print_text();
    return undecoded_.finish();
  }

 private:
  [[nodiscard]] bool is_numbered(std::uint16_t id) const {
    const auto found = recording_.summary().channels.find(id);
    return found != recording_.summary().channels.end() &&
           !found->second.metadata.contains(monitor::kSequenceGaps);
  }

  void print_json() const {
    Json json{{"topics", Json::object()}, {"fields", Json::object()}};
    for (const auto& [name, statistics] : topics_) json["topics"][name] = statistics.figures();
    for (const auto& [name, statistics] : fields_) json["fields"][name] = statistics.figures();
    std::cout << ordered_json_text(json, 2) << '\n';
  }

  void print_text() const {
    print_topics(topics_);
    for (const auto& [name, statistics] : fields_)
      std::cout << '\n' << visible(name) << '\n' << monitor::readable_text(statistics.figures());
  }

  const Recording& recording_;
  const StatsOptions& options_;
  monitor::MessageTrees trees_;
  Undecoded undecoded_;
  std::map<std::string, TopicStatistics> topics_;
  std::map<std::string, FieldStatistics> fields_;
};

}  // namespace

int print_statistics(const StatsOptions& options) {
  const auto recording = Recording::open(options.file);
  if (!recording) return fail_stats(recording.error().message);
  Selection selection = options.selection;
  if (!options.fields.empty() && selection.topics.empty()) {
    const auto topic = recording.value().only_topic();
    if (!topic) return fail_stats(topic.error().message + " (--topic), for its fields");
    selection.topics = {topic.value()};
  }
  auto messages = SelectedMessages::of(recording.value(), selection);
  if (!messages) return fail_stats(messages.error().message);
  Statistics statistics(recording.value(), options);
  while (const mcap::Message* message = messages.value().next())
    if (auto done = statistics.add(*message, messages.value().at_s()); !done)
      return fail_stats(done.error().message);
  if (selection.from_s <= 0 && !selection.to_s) {
    if (const auto losses =
            monitor::told_losses(recording.value().source(), recording.value().summary()))
      statistics.take(*losses);
    statistics.take(messages.value().damages());
  }
  tell_nothing(kStats, selection, messages.value());
  const int undecoded = statistics.print();
  const int damaged = tell_damage(kStats, messages.value());
  if (!std::cout.flush()) return kFailed;
  return undecoded != 0 ? undecoded : damaged;
}

}  // namespace galilean::logs
