// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/wire/topic_reports.h"

#include <algorithm>
#include <map>
#include <set>

#include "core/plural.h"
#include "core/visible_text.h"
#include "monitor/wire/definitions.h"
#include "monitor/wire/qos_report.h"
#include "monitor/wire/topic_name.h"

namespace galilean::monitor {
namespace {

std::string shown(const MessageTree& text) {
  return visible(text.get_ref<const std::string&>());
}

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(width, text.size()), ' ');
  return text;
}

std::string joined(const MessageTree& texts) {
  std::string all;
  for (const auto& text : texts) all += (all.empty() ? "" : ", ") + shown(text);
  return all;
}

std::string dot_quoted(const MessageTree& text) {
  std::string quoted = "\"";
  for (const char letter : shown(text)) {
    if (letter == '"' || letter == '\\') quoted += '\\';
    quoted += letter;
  }
  return quoted + '"';
}

/// Returns what is worth to be told of an end's definition.
std::string definition_clause(const MessageTree& word) {
  if (word == definition_word(Definition::kOther)) return "; its definition differs from ours";
  if (word == definition_word(Definition::kUnpublished)) return "; it publishes no definition";
  return {};
}

}  // namespace

MessageTree topic_list(EndpointList endpoints) {
  struct Row {
    std::set<std::string> types;
    int writers = 0, readers = 0;
  };
  std::map<std::string, Row> rows;
  for (const auto& endpoint : endpoints) {
    Row& row = rows[shown_topic(endpoint.topic)];
    row.types.insert(shown_type(endpoint.dds_type));
    ++(endpoint.writes ? row.writers : row.readers);
  }
  auto list = MessageTree::array();
  for (const auto& [topic, row] : rows)
    list.push_back({{"topic", topic},
                    {"types", row.types},
                    {"writers", row.writers},
                    {"readers", row.readers}});
  return list;
}

std::string topic_list_text(const MessageTree& list) {
  std::size_t topics = 0, types = 0;
  for (const auto& row : list) {
    topics = std::max(topics, shown(row["topic"]).size());
    types = std::max(types, joined(row["types"]).size());
  }
  std::string text;
  for (const auto& row : list)
    text += padded(shown(row["topic"]), topics) + "  " + padded(joined(row["types"]), types) +
            "  " + plural(row["writers"].get<int>(), "writer") + ", " +
            plural(row["readers"].get<int>(), "reader") + '\n';
  return text;
}

MessageTree topic_info(EndpointList endpoints) {
  std::set<std::string> types;
  auto writers = MessageTree::array(), readers = MessageTree::array(),
       conflicts = MessageTree::array();
  for (const auto& endpoint : endpoints) {
    types.insert(shown_type(endpoint.dds_type));
    (endpoint.writes ? writers : readers)
        .push_back({{"participant", endpoint.process},
                    {"type", shown_type(endpoint.dds_type)},
                    {"definition", definition_word(definition_of(endpoint))},
                    {"qos", qos_tree(endpoint.qos)}});
  }
  for (const auto& writer : endpoints)
    for (const auto& reader : endpoints) {
      if (!writer.writes || reader.writes) continue;
      if (const auto reasons = mismatches(writer, reader); !reasons.empty())
        conflicts.push_back({{"writer", writer.process},
                             {"writer_qos", qos_tree(writer.qos)},
                             {"reader", reader.process},
                             {"reader_qos", qos_tree(reader.qos)},
                             {"reasons", reasons}});
    }
  return {{"topic", shown_topic(endpoints.front().topic)},
          {"types", types},
          {"writers", writers},
          {"readers", readers},
          {"mismatches", conflicts}};
}

std::string topic_info_text(const MessageTree& info) {
  std::string text = shown(info["topic"]) + "  " + joined(info["types"]) + '\n';
  for (const auto* side : {"writers", "readers"})
    for (const auto& end : info[side])
      text += std::string(side == std::string_view("writers") ? "  written by " : "  read by ") +
              shown(end["participant"]) + " (" + qos_text(end["qos"]) + ")" +
              definition_clause(end["definition"]) + '\n';
  for (const auto& pair : info["mismatches"]) {
    text += "  " + shown(pair["writer"]) + " (" + qos_text(pair["writer_qos"]) +
            ") does not reach " + shown(pair["reader"]) + " (" + qos_text(pair["reader_qos"]) +
            "):\n";
    for (const auto& reason : pair["reasons"]) text += "    " + shown(reason) + '\n';
  }
  return text;
}

MessageTree process_graph(EndpointList endpoints) {
  struct Topics {
    std::set<std::string> written, read;
  };
  std::map<std::string, Topics> processes;
  for (const auto& endpoint : endpoints) {
    Topics& topics = processes[endpoint.process];
    (endpoint.writes ? topics.written : topics.read).insert(shown_topic(endpoint.topic));
  }
  auto graph = MessageTree::array();
  for (const auto& [name, topics] : processes)
    graph.push_back({{"participant", name}, {"writes", topics.written}, {"reads", topics.read}});
  return graph;
}

std::string process_graph_text(const MessageTree& graph) {
  std::string text;
  for (const auto& process : graph) {
    text += shown(process["participant"]) + '\n';
    for (const auto& topic : process["writes"]) text += "  writes " + shown(topic) + '\n';
    for (const auto& topic : process["reads"]) text += "  reads  " + shown(topic) + '\n';
  }
  return text;
}

std::string process_graph_dot(const MessageTree& graph) {
  std::set<std::string> topics;
  std::string arrows;
  for (const auto& process : graph) {
    const std::string name = dot_quoted(process["participant"]);
    for (const auto& topic : process["writes"])
      topics.insert(dot_quoted(topic)), arrows += "  " + name + " -> " + dot_quoted(topic) + ";\n";
    for (const auto& topic : process["reads"])
      topics.insert(dot_quoted(topic)), arrows += "  " + dot_quoted(topic) + " -> " + name + ";\n";
  }
  std::string text = "digraph wire {\n  rankdir=LR;\n";
  for (const auto& topic : topics) text += "  " + topic + " [shape=box];\n";
  return text + arrows + "}\n";
}

}  // namespace galilean::monitor
