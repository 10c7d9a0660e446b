// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <set>

#include "core/command_line/exit_code.h"
#include "core/json_text.h"
#include "core/visible_text.h"
#include "core/wire/types/type_text.h"
#include "monitor/wire/topic_commands.h"
#include "monitor/wire/topic_name.h"
#include "monitor/wire/topic_reports.h"
#include "monitor/wire/wire_session.h"

namespace galilean::monitor {
namespace {

const std::string kNobody =
    "nobody writes or reads a topic; check that robots run, and in the same DDS domain (--domain "
    "or ROS_DOMAIN_ID)";

void print_tree(const MessageTree& tree) {
  std::cout << ordered_json_text(tree) << std::endl;
}

/// Returns the endpoints of each topic that `name` names, or of all topics of a robot of that name.
std::vector<std::vector<wire::EndpointInfo>> named(const std::string& name,
                                                   EndpointList endpoints) {
  const std::string robot = (name.starts_with('/') ? name : "/" + name) + "/";
  const auto select = [&](const auto& wanted) {
    std::vector<std::vector<wire::EndpointInfo>> topics;
    for (const auto& endpoint : endpoints) {  // ordered by topic
      if (!wanted(endpoint.topic)) continue;
      if (topics.empty() || topics.back().front().topic != endpoint.topic) topics.emplace_back();
      topics.back().push_back(endpoint);
    }
    return topics;
  };
  auto exact = select([&](const std::string& topic) { return names_topic(name, topic); });
  if (!exact.empty()) return exact;
  return select([&](const std::string& topic) { return shown_topic(topic).starts_with(robot); });
}

/// Returns the definitions of the types that a topic's ends have, each once, or why there is none.
MessageTree definitions_of(const std::vector<wire::EndpointInfo>& ends, Definitions& definitions) {
  auto list = MessageTree::array();
  std::set<std::pair<std::string, std::string>> done;
  for (const auto& end : ends) {
    if (!done.emplace(end.dds_type, end.type_hash).second) continue;
    const auto type = definitions.find(end);
    list.push_back({{"type", shown_type(end.dds_type)},
                    {"participant", end.process},
                    {"idl", type ? MessageTree(wire::type_text(type.value())) : MessageTree()},
                    {"problem", type ? MessageTree() : MessageTree(type.error().message)}});
  }
  return list;
}

std::string definitions_text(const MessageTree& list) {
  std::string text;
  for (const auto& each : list) {
    const std::string participant = visible(each["participant"].get<std::string>());
    text += "\n// " + visible(each["type"].get<std::string>()) + " as " + participant + " has it\n";
    text += each["idl"].is_string() ? each["idl"].get<std::string>()
                                    : "// " + each["problem"].get<std::string>() + "\n";
  }
  return text;
}

}  // namespace

int list_topics(const TopicOptions& options) {
  const auto session = WireSession::join(options.domain);
  if (!session) return fail_topic_verb("list", session.error().message);
  const auto list = topic_list(session.value()->discover());
  if (options.json)
    print_tree(list);
  else
    std::cout << topic_list_text(list) << std::flush;
  if (list.empty()) return fail_topic_verb("list", kNobody);
  return 0;
}

int inform_on_topic(const TopicOptions& options) {
  const auto session = WireSession::join(options.domain);
  if (!session) return fail_topic_verb("info", session.error().message);
  const auto endpoints = session.value()->discover();
  const auto topics = named(options.name, endpoints);
  if (topics.empty()) return fail_topic_verb("info", unknown_topic(options.name, endpoints));
  auto all = MessageTree::array();
  for (const auto& topic : topics) {
    auto& info = all.emplace_back(topic_info(topic));
    if (!options.json) std::cout << topic_info_text(info);
    if (!options.definition) continue;
    info["definitions"] = definitions_of(topic, session.value()->definitions());
    if (!options.json) std::cout << definitions_text(info["definitions"]);
  }
  if (options.json) print_tree(all);
  return 0;
}

int draw_graph(const TopicOptions& options) {
  const auto session = WireSession::join(options.domain);
  if (!session) return fail_topic_verb("graph", session.error().message);
  const auto graph = process_graph(session.value()->discover());
  if (options.json)
    print_tree(graph);
  else
    std::cout << (options.format == "dot" ? process_graph_dot(graph) : process_graph_text(graph))
              << std::flush;
  if (graph.empty()) return fail_topic_verb("graph", kNobody);
  return 0;
}

}  // namespace galilean::monitor
