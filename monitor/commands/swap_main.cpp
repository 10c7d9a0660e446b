// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <nlohmann/json.hpp>

#include "bhdl/check.h"
#include "core/command_line/command_line.h"
#include "core/command_line/domain_option.h"
#include "core/command_line/seconds_of.h"
#include "core/json_text.h"
#include "monitor/access/operator_key.h"
#include "monitor/commands/direct_swap.h"
#include "monitor/commands/push_session.h"

namespace {
using namespace galilean::monitor;
namespace bhdl = galilean::bhdl;

int refuse(const std::vector<bhdl::Diagnostic>& problems, bool as_json) {
  if (as_json) {
    std::cout << galilean::json_text(nlohmann::json{{"ok", false}, {"diagnostics", problems}})
              << std::endl;
    return galilean::kFailed;
  }
  for (const auto& problem : problems) std::cerr << bhdl::format(problem) << '\n';
  std::cerr << "galilean swap: nothing was pushed" << std::endl;
  return galilean::kFailed;
}

int swap_through_monitor(const DirectSwapOptions& options) {
  // The monitor checks the program against the robots' catalogs. It has none of this machine's
  // files, and would take an include that is missing here from the programs that ship.
  const auto files = bhdl::read_program(options.file);
  if (!files) return refuse(files.error(), options.push.json);
  const auto monitor =
      MonitorClient::at(options.push.monitor, options.push.token_file, options.push.trust);
  if (!monitor) {
    std::cerr << "galilean swap: " << monitor.error().message << std::endl;
    return galilean::kFailed;
  }
  return push_through(monitor.value(), "galilean swap", files.value(), options.push);
}

}  // namespace

int main(int argc, char** argv) {
  DirectSwapOptions options;
  bool direct = false;
  galilean::CommandLine app("Swaps the program of running robots, without a stop.",
                            "galilean swap");
  app.option("file", options.file, "the program, a BHDL file").required().names_file(".bhdl");
  add_push_options(app, options.push);
  add_monitor_option(app, options.push);
  const auto directly = app.flag("--direct", direct,
                                 "over DDS, without a monitor: to robots that trust the key, or "
                                 "were started with --accept-swaps-from naming this program");
  for (const auto* other :
       {"--try", "--try-only", "--canary", "--probation", "--monitor", "--token-file"})
    app.find(other).excludes(directly);
  galilean::add_seconds_option(app, "--timeout", options.timeout_s,
                               "how long to wait for answers, such as 5s (with --direct)");
  galilean::add_domain_option(app, options.domain, "with --direct");
  add_key_option(app, options.key_file, "with --direct");
  if (const auto code = app.parse(argc, argv)) return *code;
  if (const auto targets = check_targets(options.push); !targets)
    return app.refuse(targets.error().message);
  return direct ? swap_directly(options) : swap_through_monitor(options);
}
