// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/damage_text.h"

#include <algorithm>

#include "core/plural.h"
#include "core/visible_text.h"
#include "monitor/record/times.h"

namespace galilean::monitor {
namespace {

/// Of more than so many damages or silences, the rest is counted.
constexpr std::size_t kListed = 20;

using Counts = std::map<std::uint16_t, std::uint64_t>;

/// Returns " (/io/state 12, /io/log 3)"; empty if nothing is known.
std::string by_topic(const Counts& counts, const mcap::Summary& summary) {
  std::map<std::string, std::uint64_t> topics;
  for (const auto& [channel, messages] : counts) topics[topic_of(channel, summary)] += messages;
  std::string text;
  for (const auto& [topic, messages] : topics)
    text += (text.empty() ? " (" : ", ") + visible(topic) + ' ' + std::to_string(messages);
  return text.empty() ? text : text + ')';
}

std::string from_to(const mcap::TimeRange& time) {
  return " from " + iso_time(time.start_ns) + " to " + iso_time(time.end_ns);
}

template <class Items, class Line>
void list(std::string& text, const Items& items, std::string_view noun, Line line) {
  for (std::size_t i = 0; i < std::min(items.size(), kListed); ++i) text += line(items[i]) + '\n';
  if (items.size() > kListed)
    text += "and " + plural(items.size() - kListed, noun) + " more; --json lists all\n";
}

}  // namespace

std::string topic_of(std::uint16_t channel, const mcap::Summary& summary) {
  const auto known = summary.channels.find(channel);
  return known == summary.channels.end() ? "channel " + std::to_string(channel)
                                         : known->second.topic;
}

std::string damage_text(const mcap::Damage& damage, const mcap::Summary& summary) {
  std::string text = visible(damage.what);
  if (damage.messages == std::uint64_t{0}) return text + "; no message is lost by it";
  text += ": ";
  text += damage.messages ? plural(*damage.messages, "message") : "an unknown number of messages";
  if (damage.time) text += from_to(*damage.time);
  text += agreeing(damage.messages.value_or(1), " is lost", " are lost");
  return text + by_topic(damage.channel_messages, summary);
}

std::string loss_text(const mcap::Summary& summary) {
  std::uint64_t lost = 0;
  for (const auto& [channel, messages] : summary.lost) lost += messages;
  if (lost == 0) return summary.lost_is_exact ? "" : "it is not known how many messages are lost";
  return (summary.lost_is_exact ? "" : "at least ") + plural(lost, "message") +
         agreeing(lost, " is", " are") + " lost in all" + by_topic(summary.lost, summary);
}

std::string silence_text(const mcap::TimeRange& silence) {
  return "no message for " +
         time_span(static_cast<double>(silence.end_ns - silence.start_ns) * 1e-9) +
         from_to(silence) + "; a replay goes on at once";
}

std::string condition_text(const std::string& path, const mcap::Summary& summary) {
  std::string text;
  const std::string so_far = plural(summary.statistics.messages, "message");
  if (!summary.closed && summary.being_written)
    text += path + " is being written; it has " + so_far + " so far\n";
  else if (!summary.closed)
    text += path + " was not closed properly; recovered " + so_far + "\n";
  list(text, summary.damages, "damage",
       [&](const mcap::Damage& damage) { return "damage: " + damage_text(damage, summary); });
  if (const auto loss = loss_text(summary); !loss.empty()) text += "lost: " + loss + '\n';
  list(text, summary.silences, "silence",
       [](const mcap::TimeRange& silence) { return "silence: " + silence_text(silence); });
  return text;
}

}  // namespace galilean::monitor
