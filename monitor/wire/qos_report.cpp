// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/wire/qos_report.h"

#include <algorithm>
#include <array>

#include "core/json_text.h"
#include "monitor/wire/topic_name.h"

namespace galilean::monitor {
namespace {

using wire::EndpointInfo;
using wire::EndpointQos;

std::string durability_word(EndpointQos::Durability durability) {
  constexpr std::array kWords{"volatile", "transient-local", "transient", "persistent"};
  return kWords.at(static_cast<std::size_t>(durability));
}

std::string reliability_word(bool reliable) {
  return reliable ? "reliable" : "best effort";
}

}  // namespace

MessageTree qos_tree(const EndpointQos& qos) {
  return {{"reliability", reliability_word(qos.reliable)},
          {"durability", durability_word(qos.durability)},
          {"history", qos.depth == 0 ? "keep all" : "keep last " + std::to_string(qos.depth)},
          {"deadline_s", qos.deadline_ns == INT64_MAX
                             ? MessageTree()
                             : MessageTree(static_cast<double>(qos.deadline_ns) * 1e-9)},
          {"ownership", qos.exclusive ? "exclusive" : "shared"}};
}

std::string qos_text(const MessageTree& qos) {
  std::string text;
  for (const auto& [name, value] : qos.items())
    if (value.is_string() && value != "shared")
      text += (text.empty() ? "" : ", ") + value.get<std::string>();
  if (qos["deadline_s"].is_number())
    text += ", deadline " + ordered_json_text(qos["deadline_s"]) + " s";
  return text;
}

EndpointQos least_qos(std::span<const EndpointInfo> ends) {
  if (ends.empty()) return {};
  EndpointQos least = ends.front().qos;
  for (const auto& end : ends) {
    least.reliable = least.reliable && end.qos.reliable;
    least.durability = std::min(least.durability, end.qos.durability);
  }
  return least;
}

std::vector<std::string> mismatches(const EndpointInfo& writer, const EndpointInfo& reader) {
  const EndpointQos& offered = writer.qos;
  const EndpointQos& asked = reader.qos;
  std::vector<std::string> reasons;
  if (writer.dds_type != reader.dds_type)
    reasons.push_back("the writer's type is " + shown_type(writer.dds_type) + ", the reader's " +
                      shown_type(reader.dds_type));
  if (asked.reliable && !offered.reliable)
    reasons.emplace_back("the reader asks for reliable, the writer offers best effort");
  if (asked.durability > offered.durability)
    reasons.push_back("the reader asks for " + durability_word(asked.durability) +
                      ", the writer offers " + durability_word(offered.durability));
  if (asked.deadline_ns < offered.deadline_ns)
    reasons.emplace_back("the reader asks for a shorter deadline than the writer offers");
  if (asked.exclusive != offered.exclusive)
    reasons.emplace_back("one side's ownership is exclusive, the other's is shared");
  return reasons;
}

}  // namespace galilean::monitor
