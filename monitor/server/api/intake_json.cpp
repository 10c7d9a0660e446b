// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/api/intake_json.h"

namespace galilean::monitor {

nlohmann::json channels_json(const Intake& intake) {
  auto list = nlohmann::json::array();
  for (const auto& channel : intake.channels) {
    nlohmann::json age_s = nullptr;
    if (channel.age_s) age_s = *channel.age_s;
    list.push_back({{"topic", channel.topic},
                    {"messages", channel.messages},
                    {"age_s", std::move(age_s)},
                    {"filled", channel.filled},
                    {"lost", channel.lost}});
  }
  return list;
}

nlohmann::json refused_json(const Intake& intake) {
  auto list = nlohmann::json::array();
  for (const auto& each : intake.refused)
    list.push_back({{"topic", each.topic}, {"reason", each.reason}, {"messages", each.messages}});
  return list;
}

}  // namespace galilean::monitor
