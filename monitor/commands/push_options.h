// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/account.h"

namespace galilean::monitor {

/// How commands push a program.
struct PushOptions {
  std::string monitor = "http://127.0.0.1:8080";
  std::string token_file;
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

/// --monitor, --token-file
void add_monitor_option(CLI::App& app, PushOptions& options);
/// --team, --robot, --author, --replaces, --try, --try-only, --even-if-worse, --canary,
/// --probation, --json
void add_push_options(CLI::App& app, PushOptions& options);
/// Throws CLI::ValidationError where nobody is named.
void require_targets(const PushOptions& options);

}  // namespace galilean::monitor
