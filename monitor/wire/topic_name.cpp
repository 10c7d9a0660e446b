// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/wire/topic_name.h"

#include <set>

#include "core/spelling.h"
#include "core/visible_text.h"

namespace galilean::monitor {
namespace {

constexpr std::string_view kRosTopicPrefix = "rt/";  // stands before ROS 2 topics' names on DDS
constexpr std::string_view kRosTypeRoom = "::dds_::";

std::string_view without_slash(std::string_view name) {
  if (name.starts_with('/')) name.remove_prefix(1);
  return name;
}

}  // namespace

std::string shown_topic(std::string_view dds_topic) {
  if (dds_topic.starts_with(kRosTopicPrefix)) dds_topic.remove_prefix(kRosTopicPrefix.size() - 1);
  return std::string(dds_topic);
}

std::string shown_type(std::string_view dds_type) {
  const auto room = dds_type.find(kRosTypeRoom);
  if (room == dds_type.npos || !dds_type.ends_with('_')) return std::string(dds_type);
  std::string package(dds_type.substr(0, room));
  if (const auto colons = package.find("::"); colons != package.npos)
    package.replace(colons, 2, "/");
  const auto name = dds_type.substr(room + kRosTypeRoom.size());
  return package + "/" + std::string(name.substr(0, name.size() - 1));
}

bool names_topic(std::string_view user, std::string_view dds_topic) {
  return user == dds_topic || without_slash(user) == without_slash(shown_topic(dds_topic));
}

std::string unknown_topic(std::string_view user, std::span<const wire::EndpointInfo> known) {
  std::set<std::string> shown;
  for (const auto& endpoint : known) shown.insert(shown_topic(endpoint.topic));
  std::vector<std::string_view> names;
  for (const auto& name : shown) names.push_back(without_slash(name));
  const std::string meant = meant_name(without_slash(user), names);
  std::string sentence = "nobody writes or reads '" + visible(user) + "'";
  if (!meant.empty()) return sentence + "; did you mean '/" + visible(meant) + "'?";
  if (names.empty())
    return sentence +
           "; check that robots run, and in the same DDS domain (--domain or ROS_DOMAIN_ID)";
  return sentence + "; 'galilean list' lists the topics";
}

}  // namespace galilean::monitor
