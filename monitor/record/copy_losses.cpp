// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/copy_losses.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>
#include <utility>

#include "core/json_text.h"
#include "core/plural.h"
#include "core/visible_text.h"
#include "monitor/record/damage_text.h"

namespace galilean::monitor {
namespace {

constexpr std::size_t kMostTimes = 64;
constexpr const char* kCopyReason = "damaged in the file that it was copied from";

template <class Key>
std::uint64_t sum_of(const std::map<Key, std::uint64_t>& counts) noexcept {
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const auto& each) { return sum + each.second; });
}

bool overlap(const mcap::TimeRange& a, const mcap::TimeRange& b) noexcept {
  return a.start_ns <= b.end_ns && b.start_ns <= a.end_ns;
}

bool is_inside(const mcap::TimeRange& inner, const mcap::TimeRange& outer) noexcept {
  return outer.start_ns <= inner.start_ns && inner.end_ns <= outer.end_ns;
}

/// Adds a time. Beyond the most, the newest grows to cover it.
void add_lost_time(std::vector<mcap::TimeRange>& times, const mcap::TimeRange& time) {
  if (times.size() < kMostTimes) return times.push_back(time);
  times.back() = {std::min(times.back().start_ns, time.start_ns),
                  std::max(times.back().end_ns, time.end_ns)};
}

/// Takes the times of damages. One without a time may have lost messages of any.
void take_times(const std::vector<mcap::Damage>& damages, CopyLosses& losses) {
  const auto loses = [](const mcap::Damage& each) { return each.messages != std::uint64_t{0}; };
  const bool all_known = std::ranges::all_of(
      damages, [&](const mcap::Damage& each) { return !loses(each) || each.time; });
  if (!all_known) return losses.times.clear();
  for (const auto& each : damages)
    if (loses(each)) add_lost_time(losses.times, *each.time);
}

CopyLosses losses_of_all(const mcap::Summary& summary, const std::vector<mcap::Damage>& damages) {
  CopyLosses losses;
  const auto channels = lost_by_channel(summary, damages);
  for (const auto& [channel, messages] : channels)
    losses.topics[topic_of(channel, summary)] += messages;
  std::uint64_t of_damages = 0;
  bool all_counted = true;
  for (const auto& damage : damages) {
    of_damages += damage.messages.value_or(0);
    all_counted &= damage.messages.has_value();
  }
  const auto known = sum_of(channels);
  losses.others = of_damages - std::min(of_damages, known);
  losses.is_exact = summary.checked ? summary.lost_is_exact : all_counted;
  const bool is_cut = !summary.closed && !summary.being_written;
  if (is_cut) losses.is_exact = false;
  take_times(damages, losses);
  const bool at_any_time = losses.times.empty() && !damages.empty() && losses.any();
  if (is_cut && !at_any_time)
    add_lost_time(losses.times,
                  {summary.statistics.end_ns + 1, std::numeric_limits<std::uint64_t>::max()});
  return losses;
}

/// What begins or ends within a damage has lost an unknown number of its messages.
void cut_time(const mcap::TimeRange& part, CopyLosses& losses) {
  if (!losses.any()) return;
  const bool is_all_inside =
      !losses.times.empty() &&
      std::ranges::all_of(losses.times, [&](const auto& time) { return is_inside(time, part); });
  if (is_all_inside) return;
  const bool at_any_time = losses.times.empty();
  std::erase_if(losses.times, [&](const auto& time) { return !overlap(time, part); });
  const bool is_touched = at_any_time || !losses.times.empty();
  losses.topics.clear();
  losses.others = 0;
  losses.is_exact = !is_touched;
}

void cut_topics(const std::function<bool(const std::string&)>& takes, CopyLosses& losses) {
  std::erase_if(losses.topics, [&](const auto& each) { return !takes(each.first); });
  if (std::exchange(losses.others, 0) > 0) losses.is_exact = false;
}

std::string value_of(const mcap::Text& entries, const std::string& name) {
  const auto found = entries.find(name);
  return found == entries.end() ? "" : found->second;
}

/// Returns the number that the text is; nothing if it is none.
std::optional<std::uint64_t> whole_number(const std::string& text) {
  std::uint64_t number = 0;
  const auto* end = text.data() + text.size();
  const auto [stop, failure] = std::from_chars(text.data(), end, number);
  if (text.empty() || failure != std::errc() || stop != end) return std::nullopt;
  return number;
}

/// Returns whether all could be read.
bool read_topics(const std::string& text, CopyLosses& losses) {
  const auto read = read_untrusted_json(text);
  if (!read || !read.value().is_object()) return false;
  for (const auto& [topic, messages] : read.value().items()) {
    if (!messages.is_number_unsigned()) return false;
    losses.topics[topic] = messages.get<std::uint64_t>();
  }
  return true;
}

/// Times need 64 bits, which a number in JSON does not have everywhere: they are texts.
bool read_times(const std::string& text, CopyLosses& losses) {
  const auto read = read_untrusted_json(text);
  if (!read || !read.value().is_array()) return false;
  std::vector<mcap::TimeRange> times;
  for (const auto& each : read.value()) {
    if (!each.is_array() || each.size() != 2 || !each[0].is_string() || !each[1].is_string())
      return false;
    const auto start = whole_number(each[0].get<std::string>()),
               end = whole_number(each[1].get<std::string>());
    if (!start || !end) return false;
    add_lost_time(times, {*start, *end});
  }
  losses.times = std::move(times);
  return true;
}

CopyLosses read_copy_losses(const mcap::Text& entries) {
  CopyLosses losses{.file = value_of(entries, "file")};
  const auto others = whole_number(value_of(entries, "others"));
  losses.others = others.value_or(0);
  const bool is_read = read_topics(value_of(entries, "topics"), losses) &&
                       read_times(value_of(entries, "times"), losses) && others;
  losses.is_exact = is_read && value_of(entries, "exact") == "true";
  return losses;
}

}  // namespace

std::uint64_t CopyLosses::missing() const noexcept {
  return sum_of(topics) + others;
}

std::map<std::uint16_t, std::uint64_t> lost_by_channel(const mcap::Summary& summary,
                                                       const std::vector<mcap::Damage>& damages) {
  std::map<std::uint16_t, std::uint64_t> of_damages;
  for (const auto& damage : damages)
    for (const auto& [channel, messages] : damage.channel_messages) of_damages[channel] += messages;
  auto lost = summary.lost;
  for (const auto& [channel, messages] : of_damages)
    lost[channel] = std::max(lost[channel], messages);
  return lost;
}

CopyLosses losses_of_copying(const std::string& file, const mcap::Summary& summary,
                             const std::vector<mcap::Damage>& damages, const CopiedPart& part) {
  auto losses = part_of(losses_of_all(summary, damages), part);
  losses.file = std::filesystem::path(file).filename().string();
  return losses;
}

CopyLosses part_of(CopyLosses losses, const CopiedPart& part) {
  if (part.time) cut_time(*part.time, losses);
  if (part.takes) cut_topics(part.takes, losses);
  return losses;
}

mcap::Metadata metadata_of(const CopyLosses& losses) {
  auto times = nlohmann::ordered_json::array();
  for (const auto& time : losses.times)
    times.push_back({std::to_string(time.start_ns), std::to_string(time.end_ns)});
  return {kCopyLossesMetadata,
          {{"file", losses.file},
           {"reason", kCopyReason},
           {"missing", std::to_string(losses.missing())},
           {"topics", ordered_json_text(nlohmann::ordered_json(losses.topics))},
           {"others", std::to_string(losses.others)},
           {"exact", losses.is_exact ? "true" : "false"},
           {"times", ordered_json_text(times)}}};
}

std::vector<CopyLosses> copy_losses(const mcap::Summary& summary) {
  std::vector<CopyLosses> all;
  for (const auto& metadata : summary.metadata)
    if (metadata.name == kCopyLossesMetadata) all.push_back(read_copy_losses(metadata.entries));
  return all;
}

std::string copy_loss_text(const CopyLosses& losses) {
  const auto missing = losses.missing();
  std::string text;
  if (missing == 0)
    text = "an unknown number of messages";
  else
    text = (losses.is_exact ? "" : "at least ") + plural(missing, "message");
  text += missing > 1 ? " are lost" : " is lost";
  text += missing == 1 ? ", which was damaged" : ", which were damaged";
  text += " or missing in " + (losses.file.empty() ? "" : visible(losses.file) + ", ") +
          "the file that it was copied from";
  std::string topics;
  for (const auto& [topic, messages] : losses.topics)
    topics += (topics.empty() ? " (" : ", ") + visible(topic) + ' ' + std::to_string(messages);
  return text + (topics.empty() ? "" : topics + ')');
}

}  // namespace galilean::monitor
