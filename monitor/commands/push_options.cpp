// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/commands/push_options.h"

#include <charconv>

namespace galilean::monitor {
namespace {

/// "10", "10s", "500ms" or "2min".
double seconds_of(const std::string& text) {
  double number = 0;
  const char* end = text.data() + text.size();
  const auto [rest, wrong] = std::from_chars(text.data(), end, number);
  const std::string unit(rest, end);
  const double factor = unit == "ms"                  ? 1e-3
                        : unit == "min"               ? 60
                        : unit.empty() || unit == "s" ? 1
                                                      : 0;
  if (wrong != std::errc() || factor == 0 || !(number >= 0))
    throw CLI::ValidationError("--probation", "'" + text + "' is no time, such as 10s");
  return number * factor;
}

}  // namespace

void add_monitor_option(CLI::App& app, PushOptions& options) {
  app.add_option("--monitor", options.monitor, "the monitor to speak to")->capture_default_str();
  app.add_option("--token-file", options.token_file,
                 "the operator's token; of a monitor on this machine it is found");
}

void add_push_options(CLI::App& app, PushOptions& options) {
  auto* team = app.add_flag("--team", options.team, "to every robot that is heard");
  app.add_option("--robot", options.robots, "to these robots")->excludes(team);
  app.add_option("--author", options.author, "who pushes, for the history")->capture_default_str();
  app.add_option("--replaces", options.replaces,
                 "refuse where another program than this hash runs");
  app.add_flag("--try", options.tries, "first in simulation, beside the program that runs");
  app.add_flag("--try-only", options.tries_only, "in simulation alone: no robot is given it");
  app.add_flag("--even-if-worse", options.even_if_worse,
               "push it though it scores clearly less in simulation");
  app.add_option("--canary", options.canary, "the robot that runs it first");
  app.add_option_function<std::string>(
      "--probation", [&](const std::string& text) { options.probation_s = seconds_of(text); },
      "for so long each robot may go back by itself, and a canary runs it alone; as 10s");
  app.add_flag("--json", options.json, "what came of it as JSON");
}

void require_targets(const PushOptions& options) {
  if (!options.team && options.robots.empty())
    throw CLI::ValidationError("say to whom: --team, or --robot NAME");
}

}  // namespace galilean::monitor
