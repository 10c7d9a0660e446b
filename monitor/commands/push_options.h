// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/account.h"
#include "core/result.h"
#include "monitor/commands/exchange.h"

namespace galilean {
class CommandLine;
}

namespace galilean::monitor {

/// The options of commands that push a program.
struct PushOptions {
  std::string monitor = "http://127.0.0.1:8080";
  std::string token_file;
  ServerTrust trust;
  bool team = false;
  std::vector<std::string> robots;
  std::string author = user_name();
  std::string replaces;
  bool tries = false;
  bool tries_only = false;
  bool even_if_worse = false;
  std::string canary;
  std::optional<double> probation_s;
  bool json = false;
};

/// Adds --monitor, --token-file, --ca and --fingerprint.
void add_monitor_option(CommandLine& app, PushOptions& options);
/// Adds --team, --robot, --author, --replaces, --try, --try-only, --even-if-worse, --canary,
/// --probation and --json.
void add_push_options(CommandLine& app, PushOptions& options);
/// Errors: the options name neither the team nor a robot.
[[nodiscard]] Result<void> check_targets(const PushOptions& options);

}  // namespace galilean::monitor
