// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/comparing/diff.h"

#include <algorithm>
#include <cstdio>
#include <iostream>

#include "core/command_line/exit_code.h"
#include "core/json_text.h"
#include "core/visible_text.h"
#include "monitor/logs/comparing/difference.h"
#include "monitor/record/times.h"

namespace galilean::logs {
namespace {

using Json = nlohmann::ordered_json;
using Kind = DifferentMessage::Kind;

constexpr const char* kDiff = "galilean log diff";

int refuse_diff(const std::string& sentence) {
  std::cerr << kDiff << ": " << sentence << '\n';
  return kNotComparable;
}

std::string place_of(const DifferentMessage& message) {
  char seconds[48];
  std::snprintf(seconds, sizeof seconds, "%.3f s (", message.at_s);
  return seconds + monitor::iso_time(message.log_ns) + "), " + visible(message.topic);
}

std::string line_of(const DifferentMessage& message, const DiffOptions& options) {
  const std::string place = place_of(message);
  if (message.kind == Kind::kOnlyFirst) return place + ": only in " + options.first;
  if (message.kind == Kind::kOnlySecond) return place + ": only in " + options.second;
  if (message.field.empty()) return place + ": the bytes differ";
  return place + ": " + visible(message.field) + " is " + visible(message.first) + " in " +
         options.first + " and " + visible(message.second) + " in " + options.second;
}

void print_text(const Difference& difference, const DiffOptions& options) {
  for (const auto& sentence : difference.channels) std::cout << sentence << '\n';
  for (const auto& [topic, counts] : difference.topics)
    if (counts.any())
      std::cout << visible(topic) << ": " << counts.equal << " equal, " << counts.changed
                << " changed, " << counts.only_first << " only in " << options.first << ", "
                << counts.only_second << " only in " << options.second << '\n';
  for (const auto& message : difference.messages)
    std::cout << "  at " << line_of(message, options) << '\n';
  if (!difference.any()) std::cout << "no difference\n";
}

void print_json(const Difference& difference) {
  constexpr const char* kWords[] = {"changed", "only first", "only second"};
  Json json{{"differ", difference.any()}, {"channels", difference.channels}};
  json["topics"] = Json::object();
  for (const auto& [topic, counts] : difference.topics)
    json["topics"][topic] = {{"equal", counts.equal},
                             {"changed", counts.changed},
                             {"only_first", counts.only_first},
                             {"only_second", counts.only_second}};
  json["messages"] = Json::array();
  for (const auto& message : difference.messages) {
    Json one{{"kind", kWords[static_cast<std::size_t>(message.kind)]},
             {"topic", message.topic},
             {"at_s", message.at_s},
             {"log_ns", std::to_string(message.log_ns)}};
    if (!message.field.empty()) {
      one["field"] = message.field;
      one["first"] = message.first;
      one["second"] = message.second;
    }
    json["messages"].push_back(std::move(one));
  }
  std::cout << ordered_json_text(json, 2) << '\n';
}

}  // namespace

int print_difference(const DiffOptions& options) {
  const auto first = Recording::open(options.first), second = Recording::open(options.second);
  for (const auto* each : {&first, &second})
    if (!*each) return refuse_diff(each->error().message);
  const Selection selection{.topics = options.topics};
  auto of_first = SelectedMessages::of(first.value(), selection);
  if (!of_first) return refuse_diff(of_first.error().message);
  auto of_second = SelectedMessages::of(second.value(), selection);
  if (!of_second) return refuse_diff(of_second.error().message);
  const auto difference = compare(of_first.value(), of_second.value());
  if (!difference) return refuse_diff(difference.error().message);
  if (options.json)
    print_json(difference.value());
  else
    print_text(difference.value(), options);
  const int damaged =
      std::max(tell_damage(kDiff, of_first.value()), tell_damage(kDiff, of_second.value()));
  if (!std::cout.flush()) return kNotComparable;
  return difference.value().any() ? kFailed : damaged;
}

}  // namespace galilean::logs
