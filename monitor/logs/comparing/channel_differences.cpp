// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/comparing/channel_differences.h"

#include <map>
#include <set>

#include "core/visible_text.h"

namespace galilean::logs {
namespace {

/// The schemas of each topic. Of several channels, each may have its own.
using SchemasOf = std::map<std::string, std::set<const mcap::Schema*>>;

SchemasOf schemas_of(const mcap::Summary& summary) {
  SchemasOf schemas;
  for (const auto& [id, channel] : summary.channels) {
    auto& of_topic = schemas[channel.topic];
    const auto schema = summary.schemas.find(channel.schema_id);
    if (schema != summary.schemas.end()) of_topic.insert(&schema->second);
  }
  return schemas;
}

std::string only_in(const std::string& topic, const Recording& there, const Recording& not_there) {
  return visible(topic) + " is in " + there.path() + " and not in " + not_there.path();
}

}  // namespace

std::vector<std::string> channel_differences(const Recording& first, const Recording& second) {
  std::vector<std::string> found;
  const auto of_first = schemas_of(first.summary()), of_second = schemas_of(second.summary());
  for (const auto& [topic, schemas] : of_first) {
    const auto other = of_second.find(topic);
    if (other == of_second.end()) {
      found.push_back(only_in(topic, first, second));
      continue;
    }
    for (const auto* a : schemas)
      for (const auto* b : other->second)
        if (a->name != b->name)
          found.push_back(visible(topic) + " has the type " + visible(a->name) + " in " +
                          first.path() + " and " + visible(b->name) + " in " + second.path());
        else if (a->data != b->data || a->encoding != b->encoding)
          found.push_back("the definition of " + visible(a->name) + ", on " + visible(topic) +
                          ", differs");
  }
  for (const auto& [topic, schemas] : of_second)
    if (!of_first.contains(topic)) found.push_back(only_in(topic, second, first));
  return found;
}

}  // namespace galilean::logs
