// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/commands/direct_swap.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <utility>

#include "bhdl/program/catalog_file.h"
#include "core/command_line/exit_code.h"
#include "core/json_text.h"
#include "core/orders/signed_writer.h"
#include "core/wire/topic_names.h"
#include "monitor/access/operator_key.h"
#include "monitor/commands/push_session.h"
#include "monitor/commands/team_listener.h"
#include "monitor/pushes/history/json.h"
#include "monitor/pushes/history/push_messages.h"
#include "monitor/pushes/history/replies.h"
#include "monitor/pushes/target_check.h"

namespace galilean::monitor {
namespace {

constexpr auto kDiscovery = std::chrono::seconds(3);

int fail(const std::string& why) {
  std::cerr << "galilean swap: " << why << std::endl;
  return kFailed;
}

int print_check_errors(const TargetCheck& check, const DirectSwapOptions& options) {
  if (options.push.json)
    std::cout << json_text(nlohmann::json{{"ok", false},
                                          {"robot", check.refused_by},
                                          {"diagnostics", check.result.diagnostics}})
              << std::endl;
  else
    for (const auto& diagnostic : check.result.diagnostics)
      std::cerr << bhdl::format(diagnostic) << '\n';
  if (!options.push.json) std::cerr << "galilean swap: nothing was pushed" << std::endl;
  return kFailed;
}

int tell_replies(const Replies& replies, const msg::ProgramPush& message,
                 const DirectSwapOptions& options) {
  const auto told = to_json(replies.all());
  if (options.push.json)
    std::cout << json_text(nlohmann::json{{"ok", replies.complete()},
                                          {"id", message.id},
                                          {"hash", message.hash},
                                          {"replies", told}})
              << std::endl;
  else
    for (const auto& reply : told) print_reply(reply);
  return replies.taken_by_all() ? EXIT_SUCCESS : kFailed;
}

/// Sends the message, waits for the replies and prints them. Returns the exit code.
int converse(TeamListener& listener, SignedWriter<msg::ProgramPush>& writer,
             const msg::ProgramPush& message, const std::vector<std::string>& robots,
             const DirectSwapOptions& options) {
  Replies replies(message.id, robots, listener.now());
  listener.on_message([&](const Message& received) {
    msg::ProgramReply reply;
    if (received.channel.schema->ros_type == msg::ProgramReply::kRosType &&
        msg::decode_cdr(*received.cdr, reply))
      replies.note(reply, listener.now());
  });
  if (!writer.write(message)) return fail("DDS did not accept the program; try again");
  listener.wait(from_seconds(options.timeout_s), [&] { return replies.complete(); });
  return tell_replies(replies, message, options);
}

}  // namespace

int swap_directly(const DirectSwapOptions& options) {
  auto signer = find_signer(options.key_file);
  if (!signer) return fail(signer.error().message);
  const auto installed = bhdl::load_catalog(bhdl::default_catalog_path());
  auto joined = TeamListener::join("swap", options.domain);
  if (!joined) return fail(joined.error().message);
  TeamListener& listener = *joined.value();
  SignedWriter<msg::ProgramPush> writer(listener.participant(), wire::kProgramPushTopic,
                                        std::move(signer).value());
  const auto robots = listener.find(options.push.robots, kDiscovery);
  if (!robots) return fail(robots.error().message);

  std::vector<Target> targets;
  std::vector<std::string> names;
  for (const auto* robot : robots.value()) {
    if (options.push.robots.empty() && !takes_what_all_take(*robot, listener.team())) continue;
    // One that sends nothing, and is known by a monitor alone, must answer, too.
    if (robot->state) targets.push_back(target_of(*robot));
    names.push_back(robot->name);
  }
  if (targets.empty()) return fail("no robot in service is heard; nothing was pushed");
  const auto check =
      check_for(targets, installed ? installed.value() : Catalog{},
                [&](const Catalog& catalog) { return bhdl::check_file(options.file, catalog); });
  if (!check.result.program) return print_check_errors(check, options);
  if (!listener.wait(kDiscovery,
                     [&] { return writer.readers() >= static_cast<int>(targets.size()); }))
    return fail("the robots do not listen for programs; they run an older version or are ending");
  const auto message = make_push(*check.result.program, options.push.author, options.push.robots,
                                 options.push.replaces);
  return converse(listener, writer, message, names, options);
}

}  // namespace galilean::monitor
