// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/model/refusal_watch.h"

#include <utility>

#include "core/plural.h"
#include "core/refusal_words.h"
#include "core/visible_text.h"

namespace galilean::monitor::top {
namespace {

constexpr std::string_view kTopicRoot = "rt/";

/// Returns "io" of "rt/io/state".
std::string sender_of(const std::string& topic) {
  if (!topic.starts_with(kTopicRoot)) return topic;
  const auto begin = kTopicRoot.size();
  return visible(topic.substr(begin, topic.find('/', begin) - begin));
}

std::string refusal_words(const wire::Refusals::Count& refused) {
  return galilean::refusal_words(refused.topic, refused.messages, refused.reason);
}

std::string loss_words(const ChannelIntake& channel) {
  const std::string topic = visible(channel.topic.substr(kTopicRoot.size() - 1));
  return plural(channel.lost, "message") + " on " + topic +
         agreeing(channel.lost, " was", " were") +
         " lost: more happened in a gap than the robot keeps";
}

}  // namespace

void RefusalWatch::note(OngoingRefusal refusal, std::uint64_t count, Time now) {
  Count& known = counts_[refusal.key];
  if (known.count != count) known.rose = now;
  known.count = count;
  known.refusal = std::move(refusal);
}

void RefusalWatch::look(const Intake& intake, Time now) {
  for (const auto& refused : intake.refused)
    note({"refused " + refused.topic + " " + refused.reason, sender_of(refused.topic),
          refusal_words(refused)},
         refused.messages, now);
  for (const auto& channel : intake.channels)
    if (channel.lost > 0)
      note({"lost " + channel.topic, sender_of(channel.topic), loss_words(channel), true},
           channel.lost, now);
  if (const auto topics = intake.topics_not_read; topics > 0)
    note({"refused topics", wire::Refusals::kOthers,
          plural(topics, "topic") + agreeing(topics, " is", " are") +
              " not read, because there are too many"},
         topics, now);
}

std::vector<OngoingRefusal> RefusalWatch::ongoing(Time now) const {
  std::vector<OngoingRefusal> list;
  for (const auto& [key, each] : counts_)
    if (now - each.rose < kGoesOn) list.push_back(each.refusal);
  return list;
}

}  // namespace galilean::monitor::top
