#include <CLI/CLI.hpp>
#include <cstdlib>
#include <iomanip>
#include <iostream>

#include "bhdl/catalog_file.h"
#include "core/account.h"
#include "monitor/programs/json.h"
#include "monitor/programs/target_check.h"
#include "monitor/programs/team_listener.h"

namespace {
namespace monitor = galilean::monitor;
namespace bhdl = galilean::bhdl;
namespace msg = galilean::msg;

constexpr int kRefused = 1;
constexpr int kCannotReach = 2;
constexpr auto kDiscovery = std::chrono::seconds(3);

struct Options {
  std::string file;
  bool team = false;
  std::vector<std::string> robots;
  std::string author = galilean::user_name();
  std::string replaces_hash;
  double timeout_s = 2;
  int domain = -1;
  bool json = false;
};

int fail(const std::string& why) {
  std::cerr << "galilean swap: " << why << std::endl;
  return kCannotReach;
}

int tell_broken(const monitor::TargetCheck& check, const Options& options) {
  if (options.json)
    std::cout << nlohmann::json{{"ok", false},
                                {"robot", check.refused_by},
                                {"diagnostics", check.result.diagnostics}}
              << std::endl;
  else
    for (const auto& diagnostic : check.result.diagnostics)
      std::cerr << bhdl::format(diagnostic) << '\n';
  if (!options.json) std::cerr << "galilean swap: nothing was pushed" << std::endl;
  return kRefused;
}

void tell_answer(const monitor::PushAnswer& answer) {
  std::cout << std::left << std::setw(14) << answer.robot << std::setw(12) << answer.status;
  if (answer.status != "no_answer")
    std::cout << std::fixed << std::setprecision(1) << answer.latency_ms << " ms";
  if (answer.status == "running")
    std::cout << "  kept " << answer.reply.kept_variables.size()
              << " variables, swapped in a tick of " << answer.reply.swap_tick_us << " us";
  if (!answer.reply.message.empty()) std::cout << "  " << answer.reply.message;
  std::cout << '\n';
  for (const auto& diagnostic : answer.reply.diagnostics)
    std::cout << "  " << diagnostic.file << ':' << diagnostic.line << ':' << diagnostic.column
              << ": " << diagnostic.severity << ": " << diagnostic.message << '\n';
}

int tell_answers(const monitor::Push& push, const Options& options) {
  const auto answers = push.answers();
  if (options.json)
    std::cout << nlohmann::json{{"ok", push.complete()},
                                {"id", push.message().id},
                                {"hash", push.message().hash},
                                {"replies", monitor::to_json(answers)}}
              << std::endl;
  else
    for (const auto& answer : answers) tell_answer(answer);
  const bool all_run = std::ranges::all_of(answers, [](const auto& answer) {
    return answer.status == "running" || answer.status == "confirmed";
  });
  return all_run ? EXIT_SUCCESS : kRefused;
}

int swap(const Options& options) {
  const auto installed = bhdl::load_catalog(bhdl::default_catalog_path());
  auto joined = monitor::TeamListener::join("galilean-swap", options.domain);
  if (!joined) return fail(joined.error().message);
  monitor::TeamListener& listener = *joined.value();
  galilean::wire::Writer<msg::ProgramPush> writer(listener.participant(),
                                                  galilean::wire::kProgramPushTopic);
  const auto robots = listener.find(options.robots, kDiscovery);
  if (!robots) return fail(robots.error().message);

  std::vector<monitor::Target> targets;
  std::vector<std::string> names;
  for (const auto* robot : robots.value()) {
    targets.push_back(monitor::target_of(*robot));
    names.push_back(robot->name);
  }
  const auto check = monitor::check_for(
      targets, installed ? installed.value() : galilean::Catalog{},
      [&](const galilean::Catalog& catalog) { return bhdl::check_file(options.file, catalog); });
  if (!check.result.program) return tell_broken(check, options);

  if (!listener.wait(kDiscovery,
                     [&] { return writer.readers() >= static_cast<int>(names.size()); }))
    return fail("the robots do not listen for programs; they run an older version or are ending");
  monitor::Push push(monitor::make_push(*check.result.program, options.author, options.robots,
                                        options.replaces_hash),
                     names, listener.now());
  listener.on_message([&](const monitor::Message& message) {
    msg::ProgramReply reply;
    if (message.channel.schema->ros_type == msg::ProgramReply::kRosType &&
        msg::decode_cdr(*message.cdr, reply))
      push.note(reply, listener.now());
  });
  if (!writer.write(push.message())) return fail("DDS did not take the program; try again");
  listener.wait(galilean::from_seconds(options.timeout_s), [&] { return push.complete(); });
  return tell_answers(push, options);
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("Swaps the program of running robots, without a stop.", "galilean swap");
  app.add_option("file", options.file, "the program, a BHDL file")->required();
  auto* team = app.add_flag("--team", options.team, "to every robot that is heard");
  auto* robots = app.add_option("--robot", options.robots, "to these robots")->excludes(team);
  app.add_option("--author", options.author, "who pushes, for the history")->capture_default_str();
  app.add_option("--replaces", options.replaces_hash,
                 "refuse where another program than this hash runs");
  app.add_option("--timeout", options.timeout_s, "seconds to wait for answers")
      ->check(CLI::PositiveNumber);
  app.add_option("--domain", options.domain, "DDS domain (ROS_DOMAIN_ID, else 0)");
  app.add_flag("--json", options.json, "answers as JSON");
  try {
    app.parse(argc, argv);
    if (team->count() + robots->count() == 0)
      throw CLI::ValidationError("say to whom: --team, or --robot NAME");
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? EXIT_SUCCESS : kCannotReach;
  }
  return swap(options);
}
