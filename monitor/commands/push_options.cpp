// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/commands/push_options.h"

#include "core/command_line/command_line.h"
#include "core/command_line/seconds_of.h"
#include "monitor/commands/monitor_client.h"
#include "monitor/tls/certificate.h"

namespace galilean::monitor {

void add_monitor_option(CommandLine& app, PushOptions& options) {
  app.option("--monitor", options.monitor, "the monitor to use")
      .check(MonitorClient::check_address)
      .show_default();
  app.option("--token-file", options.token_file,
             "file of the operator's token; not needed for a monitor on this machine")
      .names_file();
  const auto ca =
      app.option("--ca", options.trust.ca_file, "PEM file of the certificates to trust at https://")
          .names_file(".pem");
  app.option(
         "--fingerprint",
         [&options](const std::string& text) -> Result<void> {
           auto read = read_fingerprint(text);
           if (!read) return read.error();
           options.trust.fingerprint = std::move(read).value();
           return {};
         },
         "SHA-256 fingerprint of the one certificate to trust at https://, as the monitor prints "
         "it")
      .excludes(ca);
}

void add_push_options(CommandLine& app, PushOptions& options) {
  const auto team = app.flag("--team", options.team, "to every robot that sends its state");
  app.option("--robot", options.robots, "to these robots").not_empty().excludes(team);
  app.option("--author", options.author, "who pushes, as the history shows it")
      .show_default()
      .describe_default("your account's name");
  app.option("--replaces", options.replaces,
             "refuse the push if a robot runs a program with another hash than this");
  app.flag("--try", options.tries, "first compare it in simulation with the program that runs");
  app.flag("--try-only", options.tries_only, "only try it in simulation and give it to no robot");
  app.flag("--even-if-worse", options.even_if_worse,
           "push it even if it scores clearly less in simulation");
  app.option("--canary", options.canary, "the robot that runs it first");
  app.option(
      "--probation",
      [&options](const std::string& text) -> Result<void> {
        const auto seconds = seconds_of(text);
        if (!seconds) return seconds.error();
        options.probation_s = seconds.value();
        return {};
      },
      "how long each robot may roll back by itself, and a canary runs it alone, such as 10s");
  app.flag("--json", options.json, "print the result of the push as JSON");
}

Result<void> check_targets(const PushOptions& options) {
  if (!options.team && options.robots.empty())
    return Error{"Name the robots with --team or --robot NAME."};
  return {};
}

}  // namespace galilean::monitor
