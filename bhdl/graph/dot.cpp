// SPDX-License-Identifier: BSD-3-Clause
#include <map>

#include "bhdl/graph/graph.h"
#include "bhdl/graph/ways.h"

namespace galilean::bhdl {
namespace {

std::string dot_text(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + '"';
}

// The causes stand on lines of their own: inside a label, \n ends a line.
std::string dot_label(const std::vector<std::string>& causes) {
  std::string label;
  for (const auto& each : causes) {
    const std::string quoted = dot_text(each);
    label += (label.empty() ? "" : "\\n") + quoted.substr(1, quoted.size() - 2);
  }
  return '"' + label + '"';
}

std::string dot_edges(const State& state) {
  std::vector<std::string> targets;
  std::map<std::string, std::vector<std::string>> causes;
  for (const auto& way : ways_out(state)) {
    auto& of_target = causes[way.to];
    if (of_target.empty()) targets.push_back(way.to);
    of_target.push_back(way.cause);
  }
  std::string text;
  for (const auto& target : targets)
    text += "  " + dot_text(state.name) + " -> " + dot_text(target) +
            " [label=" + dot_label(causes[target]) + "];\n";
  return text;
}

}  // namespace

std::string to_dot(const Program& program) {
  // No state can have this name, because names hold no line ends.
  const std::string entry = "\"\\n\"";
  std::string text = "digraph " + dot_text(program.name) +
                     " {\n  rankdir=LR;\n  node [shape=box, style=rounded];\n  " + entry +
                     " [shape=point];\n  " + entry + " -> " + dot_text(program.start_state) + ";\n";
  for (const auto& state : program.states) text += "  " + dot_text(state.name) + ";\n";
  for (const auto& state : program.states) text += dot_edges(state);
  return text + "}\n";
}

}  // namespace galilean::bhdl
