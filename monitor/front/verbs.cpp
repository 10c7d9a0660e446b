// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/front/verbs.h"

#include <array>

#include "core/spelling.h"
#include "core/visible_text.h"

namespace galilean::front {
namespace {

constexpr std::array kVerbs{
    Verb{"demo", "galilean-demo", "", "Simulator, robots and monitor together, on this machine"},
    Verb{"robot", "galilean-robot", "", "One robot: a BHDL program on its devices"},
    Verb{"sim", "galilean-sim", "", "The simulated office, live or as fast as possible"},
    Verb{"sim ctl", "galilean-sim-ctl", "", "An instructor's orders to a running simulation"},
    Verb{"monitor", "galilean-monitor", "", "The team in a browser, with its map"},
    Verb{"tokens", "galilean-tokens", "", "Who may watch and steer through a monitor"},
    Verb{"team", "galilean-team", "", "Keys of the team for DDS Security: team keys init"},
    Verb{"top", "galilean-top", "", "The team in a terminal"},
    Verb{"record", "galilean-record", "", "Record all topics as MCAP"},
    Verb{"record pause", "galilean-record-ctl", "pause", "Let a recorder record nothing"},
    Verb{"record resume", "galilean-record-ctl", "resume", "Let it record again"},
    Verb{"replay", "galilean-replay", "", "Play a recording again, as if it were live"},
    Verb{"log", "galilean-log", "", "Read, compare and cut recordings: log info FILE"},
    Verb{"log check", "galilean-log-check", "", "Judge a recording, or a team, by expectations"},
    Verb{"list", "galilean-topic", "list", "List the topics on the wire"},
    Verb{"echo", "galilean-topic", "echo", "Print a topic's messages: echo io/state"},
    Verb{"rate", "galilean-topic", "rate", "Measure how often a topic's messages come"},
    Verb{"info", "galilean-topic", "info", "Tell who writes and reads a topic, with their QoS"},
    Verb{"graph", "galilean-topic", "graph", "Tell who writes and reads which topics"},
    Verb{"wait", "galilean-topic", "wait", "Wait until a message's field has a value"},
    Verb{"bhdl", "galilean-bhdl", "", "Check, format, compare and draw programs"},
    Verb{"bhdl test", "galilean-bhdl-test", "", "Test the expectations of programs"},
    Verb{"swap", "galilean-swap", "", "Give running robots another program"},
    Verb{"lease", "galilean-lease", "", "Ask who may steer a robot, and take turns"},
    Verb{"programs", "galilean-programs", "", "List, show, compare or restore pushed programs"},
    Verb{"start", "galilean-command", "start", "Start the contest: push the robots' bumpers"},
    Verb{"stop", "galilean-command", "stop", "Make every robot stand still, at once"},
    Verb{"hold", "galilean-command", "hold", "Make robots stand still"},
    Verb{"resume", "galilean-command", "resume", "Let robots go on"},
    Verb{"break", "galilean-break", "break", "Make robots stop or wait between two states"},
    Verb{"step", "galilean-break", "step", "Let robots go on to their next change of state"},
    Verb{"decommission", "galilean-command", "decommission", "Take robots out of service"},
    Verb{"commission", "galilean-command", "commission", "Let robots serve again"},
    Verb{"keys", "galilean-keys", "", "Print the public key that robots are to trust"},
    Verb{"doctor", "galilean-doctor", "", "Check whether this machine has what Galilean needs"},
    Verb{"manual", "galilean-manual", "manual", "Print a verb's manual page"},
    Verb{"completion", "galilean-manual", "completion", "Print a shell's completion of all this"},
};

constexpr std::array kOwnWords{
    OwnWord{"version", "Which release this is"},
    OwnWord{"help", "This list"},
};

std::string line(std::string_view name, std::string_view help) {
  constexpr std::size_t kColumn = 15;
  return "  " + std::string(name) + std::string(kColumn - name.size(), ' ') + std::string(help) +
         "\n";
}

}  // namespace

std::span<const Verb> verbs() noexcept {
  return kVerbs;
}

std::span<const OwnWord> own_words() noexcept {
  return kOwnWords;
}

const Verb* find_verb(std::string_view name) noexcept {
  for (const auto& verb : kVerbs)
    if (verb.name == name) return &verb;
  return nullptr;
}

std::string unknown_verb(std::string_view name) {
  auto names = names_of(kVerbs);
  for (const auto& word : kOwnWords) names.push_back(word.name);
  for (const std::string_view option : {"--version", "--help"}) names.push_back(option);
  const std::string meant = meant_name(name, names);
  return "galilean: there is no '" + visible(name) + "'" +
         (meant.empty() ? "; 'galilean help' lists what there is"
                        : "; did you mean '" + meant + "'?");
}

std::string usage() {
  std::string text = "usage: galilean VERB …, and 'galilean VERB --help' for each\n\n";
  for (const auto& verb : kVerbs) text += line(verb.name, verb.help);
  for (const auto& word : kOwnWords) text += line(word.name, word.help);
  return text;
}

}  // namespace galilean::front
