// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/front/doctor/intake_check.h"

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/plural.h"
#include "core/visible_text.h"

namespace galilean::front {
namespace {

using nlohmann::json;

constexpr const char* kWhat = "messages";
/// So many kinds are told; the rest is counted.
constexpr std::size_t kMostTold = 3;

struct Refused {
  std::string topic, reason;
  std::uint64_t messages = 0;
};

std::optional<Refused> refused_of(const json& item) {
  if (!item.is_object()) return {};
  const auto topic = item.find("topic"), reason = item.find("reason"),
             messages = item.find("messages");
  if (topic == item.end() || !topic->is_string() || reason == item.end() || !reason->is_string() ||
      messages == item.end() || !messages->is_number_unsigned())
    return {};
  return Refused{topic->get<std::string>(), reason->get<std::string>(),
                 messages->get<std::uint64_t>()};
}

/// Returns what was refused, the most first.
std::vector<Refused> all_refused(const json& status) {
  std::vector<Refused> all;
  if (!status.is_object() || !status.contains("refused_messages")) return all;
  for (const auto& item : status["refused_messages"])
    if (auto refused = refused_of(item)) all.push_back(std::move(*refused));
  std::ranges::stable_sort(all, std::greater<>(), &Refused::messages);
  return all;
}

/// Returns "12 messages on /io/state were not taken: RobotState.heading_rad is not a number".
std::string words_of(const Refused& refused) {
  constexpr std::string_view kTopicRoot = "rt";
  const std::string place = refused.topic.starts_with("rt/")
                                ? " on " + visible(refused.topic.substr(kTopicRoot.size()))
                                : std::string();
  return plural(refused.messages, "message") + place + agreeing(refused.messages, " was", " were") +
         " not taken: " + visible(refused.reason);
}

}  // namespace

Check intake_check(const json& status) {
  const auto refused = all_refused(status);
  if (refused.empty()) return {kWhat, true, "the monitor took all that came"};
  std::string told;
  for (std::size_t i = 0; i < std::min(refused.size(), kMostTold); ++i)
    told += (i == 0 ? "" : "; ") + words_of(refused[i]);
  if (refused.size() > kMostTold)
    told +=
        "; and of " + plural(refused.size() - kMostTold, "more kind") + ", which /api/status lists";
  return {kWhat, false, std::move(told),
          "look who writes the topic (galilean info TOPIC), and stop or update it; the monitor "
          "counts since it was started"};
}

}  // namespace galilean::front
