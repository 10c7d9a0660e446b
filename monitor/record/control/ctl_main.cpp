// SPDX-License-Identifier: BSD-3-Clause
// galilean-record-ctl pause|resume gives a recorder a command, and prints what became of it.
#include <unistd.h>

#include <iostream>

#include "core/account.h"
#include "core/command_line/command_line.h"
#include "core/command_line/domain_option.h"
#include "core/command_line/exit_code.h"
#include "core/visible_text.h"
#include "core/wire/ros_time.h"
#include "monitor/record/control/recorder_client.h"
#include "monitor/record/times.h"

namespace {

using namespace galilean;
using namespace galilean::monitor;

constexpr Duration kHear = std::chrono::seconds(4);
constexpr Duration kObey = std::chrono::seconds(5);

struct Options {
  std::string name;
  int domain = -1;
};

int fail(const std::string& verb, const std::string& why) {
  std::cerr << "galilean record " << verb << ": " << why << std::endl;
  return kFailed;
}

msg::Command command_of(std::uint8_t kind) {
  const std::int64_t now_ns = wire::wall_clock_ns();
  msg::Command command;
  command.stamp = wire::ros_time(now_ns);
  command.id = std::to_string(getpid()) + "-" + std::to_string(now_ns);
  command.author = user_name();
  command.kind = kind;
  return command;
}

/// Returns what became of the command.
std::string outcome(const RecorderStatus& before, const RecorderStatus& now) {
  const auto paused_text = [](const RecorderStatus& status) {
    return "paused since " + iso_time(static_cast<std::uint64_t>(*status.paused_since_ns));
  };
  if (now.paused_since_ns)
    return (before.paused_since_ns ? "was " : "is ") + paused_text(now) +
           (before.paused_since_ns ? " already" : "");
  return before.paused_since_ns ? "records again; it was " + paused_text(before)
                                : "was not paused, and records";
}

int run(const std::string& verb, std::uint8_t kind, const Options& options) try {
  const auto participant = wire::Participant::join("record-ctl", options.domain);
  if (!participant) return fail(verb, participant.error().message);
  RecorderClient client(*participant.value());
  const auto before = client.find(options.name, kHear);
  if (!before) return fail(verb, before.error().message);
  const std::string& name = before.value().name;
  const auto now = client.send(command_of(kind), name, kObey);
  if (!now) return fail(verb, now.error().message);
  std::cout << visible(name) << ' ' << outcome(before.value(), now.value()) << std::endl;
  return 0;
} catch (const std::exception& error) {
  return fail(verb, error.what());
}

CommandLine add(CommandLine& app, const char* name, const char* help, Options& options) {
  auto verb = app.command(name, help);
  verb.option(
          "--name", options.name,
          "The recorder, by its --name or else the name of its file without .mcap; needed where "
          "several record")
      .not_empty();
  add_domain_option(verb, options.domain);
  return verb;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CommandLine app("Pauses a recorder and lets it go on.", "galilean record");
  app.require_command();
  const auto pause =
      add(app, "pause", "Record nothing until it is resumed, and tell so in the file", options);
  const auto resume = add(app, "resume", "Record again", options);
  if (const auto code = app.parse(argc, argv)) return *code;
  return pause.chosen() ? run("pause", msg::Command_Constants::HOLD, options)
                        : run("resume", msg::Command_Constants::RESUME, options);
}
