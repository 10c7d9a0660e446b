// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/figures/topic_statistics.h"

#include <algorithm>
#include <cmath>

namespace galilean::logs {
namespace {

using Json = monitor::MessageTree;

constexpr std::size_t kMostWords = 100;

Json figures_of(const NumberStatistics& numbers) {
  if (numbers.count() == 0) return {};
  return {{"least", numbers.least()},
          {"most", numbers.most()},
          {"mean", numbers.mean()},
          {"deviation", numbers.deviation()}};
}

}  // namespace

void TopicStatistics::add(const mcap::Message& message, double at_s, bool numbered) {
  if (messages_++ == 0)
    first_s_ = at_s;
  else
    gaps_s_.add(at_s - last_s_);
  last_s_ = at_s;
  bytes_ += message.data.size();
  size_bytes_.add(static_cast<double>(message.data.size()));
  const double delay_ns =
      static_cast<double>(message.log_ns) - static_cast<double>(message.publish_ns);
  if (message.publish_ns != 0) delay_s_.add(delay_ns * 1e-9);
  note_number(message.channel_id, numbered ? message.sequence : 0);
}

/// Numbers that go back are those of several writers.
void TopicStatistics::note_number(std::uint16_t channel, std::uint32_t sequence) {
  auto& newest = newest_[channel];
  if (sequence <= newest)
    missing_ = std::nullopt;
  else if (missing_ && newest != 0)
    *missing_ += sequence - newest - 1;
  newest = sequence;
}

void TopicStatistics::set_missing(std::optional<std::uint64_t> messages) {
  missing_ = messages;
  was_counted_ = true;
}

void TopicStatistics::add_damaged(std::uint64_t messages) {
  if (!missing_) return;
  *missing_ = was_counted_ ? *missing_ + messages : std::max(*missing_, messages);
}

Json TopicStatistics::figures() const {
  const double span_s = last_s_ - first_s_;
  Json json{{"messages", messages_}, {"bytes", bytes_}};
  json["first_s"] = first_s_;
  json["last_s"] = last_s_;
  json["rate_hz"] = span_s > 0 ? Json(static_cast<double>(messages_ - 1) / span_s) : Json();
  json["bytes_per_s"] = span_s > 0 ? Json(static_cast<double>(bytes_) / span_s) : Json();
  json["gap_s"] = figures_of(gaps_s_);
  json["size_bytes"] = figures_of(size_bytes_);
  json["delay_s"] = figures_of(delay_s_);
  json["missing"] = missing_ ? Json(*missing_) : Json();
  return json;
}

void FieldStatistics::add(double at_s, const Json& value) {
  if (value.is_string()) {
    const auto& word = value.get_ref<const std::string&>();
    if (words_.contains(word) || words_.size() < kMostWords)
      ++words_[word];
    else
      ++more_words_;
    return;
  }
  const bool number = value.is_number() || value.is_boolean();
  const double here = value.is_boolean() ? (value.get<bool>() ? 1.0 : 0.0)
                      : number           ? value.get<double>()
                                         : std::nan("");
  if (!std::isfinite(here)) {
    ++others_;
    return;
  }
  if (numbers_.count() == 0) first_ = here;
  if (numbers_.count() == 0 || here < numbers_.least()) least_at_s_ = at_s;
  if (numbers_.count() == 0 || here > numbers_.most()) most_at_s_ = at_s;
  numbers_.add(here);
  last_ = here;
}

Json FieldStatistics::figures() const {
  Json json{{"numbers", numbers_.count()}, {"others", others_}};
  if (numbers_.count() > 0) {
    json.update(figures_of(numbers_));
    json["least_at_s"] = least_at_s_;
    json["most_at_s"] = most_at_s_;
    json["first"] = first_;
    json["last"] = last_;
  }
  if (words_.empty()) return json;
  json["texts"] = words_;
  json["other_texts"] = more_words_;
  return json;
}

}  // namespace galilean::logs
