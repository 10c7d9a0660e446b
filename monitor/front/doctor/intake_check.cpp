// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/front/doctor/intake_check.h"

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/plural.h"
#include "core/refusal_words.h"

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

}  // namespace

Check intake_check(const json& status) {
  const auto refused = all_refused(status);
  if (refused.empty()) return {kWhat, true, "the monitor took all that came"};
  std::string told;
  for (std::size_t i = 0; i < std::min(refused.size(), kMostTold); ++i)
    told += (i == 0 ? "" : "; ") +
            refusal_words(refused[i].topic, refused[i].messages, refused[i].reason);
  if (refused.size() > kMostTold)
    told +=
        "; and of " + plural(refused.size() - kMostTold, "more kind") + ", which /api/status lists";
  return {kWhat, false, std::move(told),
          "find out with 'galilean info TOPIC' who writes the topic, and stop or update it; the "
          "monitor counts since it was started"};
}

}  // namespace galilean::front
