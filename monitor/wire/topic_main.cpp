// SPDX-License-Identifier: BSD-3-Clause
// galilean-topic list|echo|rate|info|graph|wait shows what is on the wire, for people and scripts.
#include <iostream>

#include "core/broken_pipe.h"
#include "core/command_line/command_line.h"
#include "core/command_line/domain_option.h"
#include "core/command_line/seconds_of.h"
#include "monitor/wire/topic_commands.h"

namespace galilean::monitor {

void note_topic_verb(const std::string& verb, const std::string& sentence) {
  std::cerr << "galilean " << verb << ": " << sentence << std::endl;
}

int fail_topic_verb(const std::string& verb, const std::string& sentence) {
  note_topic_verb(verb, sentence);
  return kFailed;
}

}  // namespace galilean::monitor

namespace {

using namespace galilean;
using namespace galilean::monitor;

struct TopicVerb {
  CommandLine line;
  const char* name;
  int (*run)(const TopicOptions&);
};

CommandLine add(CommandLine& app, const char* name, const char* help, TopicOptions& options) {
  auto verb = app.command(name, help);
  verb.flag("--json", options.json, "Print JSON, one object or list a line");
  add_domain_option(verb, options.domain);
  return verb;
}

int run(const TopicVerb& verb, const TopicOptions& options) try {
  ignore_broken_pipes();
  return verb.run(options);
} catch (const std::exception& error) {
  return fail_topic_verb(verb.name, error.what());
}

constexpr const char* kTopicHelp = "The topic, such as io/state; a leading slash may be left out";

}  // namespace

int main(int argc, char** argv) {
  TopicOptions options;
  CommandLine app("Shows the topics on the wire.", "galilean");
  app.require_command();
  TopicVerb verbs[] = {
      {add(app, "list", "List the topics, their types, and how many write and read them", options),
       "list", list_topics},
      {add(app, "echo", "Print each message of a topic, whatever its type", options), "echo",
       echo_topic},
      {add(app, "rate", "Measure how often a topic's messages come", options), "rate",
       measure_rate},
      {add(app, "info", "Tell who writes and reads a topic, and who cannot match", options), "info",
       inform_on_topic},
      {add(app, "graph", "Tell which participants write and read which topics", options), "graph",
       draw_graph},
      {add(app, "wait", "Wait until an expression over messages' fields comes true", options),
       "wait", wait_for_expression}};
  auto& [list, echo, rate, info, graph, wait] = verbs;
  echo.line.option("topic", options.name, kTopicHelp).required();
  echo.line.option("--count", options.count, "End after so many messages; without it by Ctrl-C")
      .between(1, 1'000'000'000);
  echo.line.option("--field", options.field, "Print this field alone, such as stamp.sec or a[0].b");
  rate.line.option("topic", options.name, kTopicHelp).required();
  auto window = rate.line.option("--window", options.window_s, "Measure for so many seconds")
                    .positive()
                    .show_default();
  rate.line.option("--count", options.count, "Measure so many messages instead")
      .between(2, 1'000'000'000)
      .excludes(window);
  info.line.option("topic_or_robot", options.name, "A topic, or a robot for all of its topics")
      .required();
  info.line.flag("--definition", options.definition,
                 "Print the definition of the topic's type in IDL, too");
  graph.line.option("--format", options.format, "How to print it")
      .one_of({"text", "dot"})
      .show_default();
  wait.line
      .option("expression", options.name,
              "TOPIC.FIELD OP VALUE, joined by 'and' and 'or', such as "
              "'io/state.state == \"wander\"'")
      .required();
  add_seconds_option(wait.line, "--timeout", options.timeout_s,
                     "Give up after this time, such as 3s");
  if (const auto code = app.parse(argc, argv)) return *code;
  for (const auto& verb : verbs)
    if (verb.line.chosen()) return run(verb, options);
  return kWrongUsage;
}
