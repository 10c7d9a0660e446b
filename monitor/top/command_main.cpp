// SPDX-License-Identifier: BSD-3-Clause
// galilean-command stop|hold|resume|start|decommission|commission sends an operator's command to
// robots and prints the result.
#include <poll.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>

#include "core/command_line/command_line.h"
#include "core/command_line/domain_option.h"
#include "core/command_line/exit_code.h"
#include "core/termination.h"
#include "core/visible_text.h"
#include "core/wake.h"
#include "monitor/ingest/ingest.h"
#include "monitor/team/team.h"
#include "monitor/top/operator.h"

namespace {

using namespace galilean;
using namespace galilean::monitor;

constexpr std::string_view kCheck =
    "check that robots run, and in the same DDS domain (--domain or ROS_DOMAIN_ID)\n";

struct Options {
  std::vector<std::string> robots;
  bool team = false;
  int domain = -1;
};

/// Keeps the model of the team up to date while one command is given.
class TeamFeed {
 public:
  explicit TeamFeed(wire::Participant& participant)
      : team_(clock_),
        ingest_(participant, {.message = [this](const Message& m) { team_.receive(m); }},
                [this] { wake_.ring(); }) {}

  [[nodiscard]] const Team& team() const noexcept { return team_; }
  /// Waits until `condition` holds. Returns false if it does not within `most`.
  bool wait(Duration most, const std::function<bool()>& condition) {
    constexpr int kLookEach_ms = 20;
    for (const Time start = clock_.now(); clock_.now() - start < most;) {
      wake_.clear();
      ingest_.poll();
      if (condition()) return true;
      pollfd event{wake_.descriptor(), POLLIN, 0};
      ::poll(&event, 1, kLookEach_ms);
    }
    return false;
  }

 private:
  SteadyClock clock_;
  Wake wake_;
  Team team_;
  Ingest ingest_;
};

const msg::RobotState* state_of(const Team& team, const std::string& robot) {
  const Robot* found = team.find(robot);
  return found && found->state ? &*found->state : nullptr;
}

std::vector<std::string> names(const Team& team) {
  std::vector<std::string> result;
  for (const auto& [name, robot] : team.robots())
    if (robot.state && !team.silent(robot)) result.push_back(name);
  return result;
}

/// Returns whether the robot obeyed. A robot has obeyed a start if its program left its state.
bool complied(Operator::Word word, const msg::RobotState& before, const msg::RobotState& now) {
  switch (word) {
    case Operator::Word::kHold:
      return now.held;
    case Operator::Word::kResume:
      return !now.held;
    case Operator::Word::kDecommission:
      return now.out_of_service;
    case Operator::Word::kCommission:
      return !now.out_of_service;
    case Operator::Word::kStart:
      break;
  }
  return now.transitions > before.transitions;
}

std::string result_of(Operator::Word word) {
  switch (word) {
    case Operator::Word::kHold:
      return "stands still";
    case Operator::Word::kDecommission:
      return "is out of service";
    case Operator::Word::kCommission:
      return "is in service again";
    default:
      return "goes on";
  }
}

int tell(Operator::Word word, const std::string& robot, const msg::RobotState& before,
         const msg::RobotState& now) {
  const bool done = complied(word, before, now);
  if (word == Operator::Word::kStart) {
    std::cout << visible(robot) << ": "
              << visible(done ? before.state + " → " + now.state
                              : "its bumper was pushed, but it stays in " + now.state)
              << '\n';
    return 0;
  }
  std::cout << visible(robot) << ": " << (done ? result_of(word) : "did not answer; try again")
            << '\n';
  return done ? 0 : 1;
}

/// Tells of the robots that are known to be in the team, send nothing, and are none of `told`.
/// Returns whether there are such.
bool tell_silent(const Team& team, const std::vector<std::string>& told) {
  bool any = false;
  for (const auto& [name, robot] : team.robots()) {
    if (!team.silent(robot) || std::ranges::find(told, name) != told.end()) continue;
    std::cout << visible(name) << ": has sent nothing for " << std::lround(team.age_s(robot))
              << " s, so it is not known what it does\n";
    any = true;
  }
  return any;
}

int command(Operator::Word word, TeamFeed& feed, Operator& speaker, const Options& options) {
  constexpr Duration kHear = std::chrono::seconds(3), kObey = std::chrono::seconds(2);
  constexpr Duration kGather = std::chrono::milliseconds(300);
  const Team& team = feed.team();
  const auto all_heard = [&] {
    for (const auto& robot : options.robots)
      if (!state_of(team, robot)) return false;
    return !names(team).empty();
  };
  const bool heard = feed.wait(kHear, all_heard);
  feed.wait(kGather, [] { return false; });
  const auto targets = options.team ? names(team) : options.robots;
  for (const auto& robot : targets)
    if (!state_of(team, robot))
      return std::cerr << "galilean-command: " << visible(robot) << " sends no state; " << kCheck,
             1;
  if (!heard || targets.empty()) {
    (void)tell_silent(team, {});
    return std::cerr << "galilean-command: no robot sends its state; " << kCheck, 1;
  }

  std::map<std::string, msg::RobotState> before;
  for (const auto& robot : targets) before[robot] = *state_of(team, robot);
  feed.wait(kHear, [&] { return speaker.listeners() >= static_cast<int>(targets.size()); });
  if (!speaker.say(word, options.team ? std::vector<std::string>{} : targets))
    return std::cerr << "galilean-command: DDS did not accept the command; try again.\n", 1;
  feed.wait(kObey, [&] {
    for (const auto& robot : targets)
      if (!complied(word, before[robot], *state_of(team, robot))) return false;
    return true;
  });
  int result = 0;
  for (const auto& robot : targets)
    result |= tell(word, robot, before[robot], *state_of(team, robot));
  const bool all_told = !options.team || !tell_silent(team, targets);
  return word == Operator::Word::kHold && !all_told ? 1 : result;
}

/// Tells whoever listens to stand still before it is known who is there, then as `command`.
int stop(TeamFeed& feed, Operator& speaker, const Options& options) {
  constexpr Duration kFirstListener = std::chrono::seconds(1);
  if (feed.wait(kFirstListener, [&] { return speaker.listeners() > 0; }) &&
      !speaker.say(Operator::Word::kHold, {}))
    std::cerr << "galilean-command: DDS did not accept the command, which is sent again\n";
  return command(Operator::Word::kHold, feed, speaker, options);
}

int run(Operator::Word word, const Options& options, bool at_once = false) try {
  const auto participant = wire::Participant::join("command", options.domain);
  if (!participant)
    return std::cerr << "galilean-command: " << participant.error().message << '\n', 1;
  TeamFeed feed(*participant.value());
  Operator speaker(*participant.value());
  return at_once ? stop(feed, speaker, options) : command(word, feed, speaker, options);
} catch (const std::exception& error) {
  return std::cerr << "galilean-command: " << error.what() << '\n', 1;
}

[[nodiscard]] CommandLine add(CommandLine& app, const char* name, const char* help,
                              Options& options) {
  auto verb = app.command(name, help);
  auto robots = verb.option("--robot", options.robots, "The robots to command");
  const auto team = verb.flag("--team", options.team, "Command every robot that sends its state");
  add_domain_option(verb, options.domain);
  robots.excludes(team);
  return verb;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CommandLine app("Gives robots an operator's command.", "galilean");
  app.require_command();
  const std::pair<CommandLine, Operator::Word> words[] = {
      {add(app, "hold", "Stand still until resumed", options), Operator::Word::kHold},
      {add(app, "resume", "Go on after a hold", options), Operator::Word::kResume},
      {add(app, "start", "Push a bumper, which the start state waits for", options),
       Operator::Word::kStart},
      {add(app, "decommission", "Stand still until commissioned, whoever resumes", options),
       Operator::Word::kDecommission},
      {add(app, "commission", "Serve again after having been decommissioned", options),
       Operator::Word::kCommission}};
  auto stopping = app.command("stop", "Every robot stands still, at once, until resumed");
  add_domain_option(stopping, options.domain);
  if (const auto code = app.parse(argc, argv)) return *code;
  if (stopping.chosen()) {
    options.team = true;
    return run(Operator::Word::kHold, options, true);
  }
  if (!options.team && options.robots.empty())
    return std::cerr << "galilean-command: Name the robots with --team or --robot NAME.\n", 2;
  for (const auto& [line, word] : words)
    if (line.chosen()) return run(word, options);
  return kWrongUsage;
}
