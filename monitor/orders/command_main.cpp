// SPDX-License-Identifier: BSD-3-Clause
// galilean-command stop|hold|resume|start|decommission|commission sends an operator's command to
// robots and prints the result.
#include <cstdlib>
#include <iostream>
#include <map>

#include "core/command_line/command_line.h"
#include "core/command_line/domain_option.h"
#include "core/command_line/exit_code.h"
#include "core/visible_text.h"
#include "monitor/orders/break_words.h"
#include "monitor/orders/obedience.h"
#include "monitor/orders/order_session.h"

namespace {

using namespace galilean;
using namespace galilean::monitor;
using Word = Operator::Word;

int fail(const std::string& why) {
  std::cerr << "galilean-command: " << why << '\n';
  return kFailed;
}

RobotReport report_of(const OrderSession& session, const std::string& robot) {
  const msg::Breaks* told = session.breaks_of(robot);
  return {*session.state_of(robot), told ? reason_of(*told) : ""};
}

/// Prints what became of the command. Returns whether it may end well: a start that moves nobody
/// does, because a program may wait for something else.
bool tell(Word word, const std::string& robot, const RobotReport& before, const RobotReport& now) {
  std::cout << visible(robot) << ": " << visible(outcome_of(word, before, now)) << '\n';
  return word == Word::kStart || complied(word, before, now);
}

int command(Word word, OrderSession& session, Operator& speaker, const Addressees& whom) {
  const auto found = session.find(whom);
  if (!found) {
    if (whom.team) session.tell_silent({});
    return fail(found.error().message);
  }
  const auto& targets = found.value();
  std::map<std::string, RobotReport> before;
  for (const auto& robot : targets) before[robot] = report_of(session, robot);
  session.wait(OrderSession::kHear,
               [&] { return speaker.listeners() >= static_cast<int>(targets.size()); });
  if (!speaker.say(word, whom.team ? std::vector<std::string>{} : targets))
    return fail("DDS did not accept the command; try again.");
  session.wait(OrderSession::kAnswer, [&] {
    for (const auto& robot : targets)
      if (!complied(word, before[robot], report_of(session, robot))) return false;
    return true;
  });
  bool all_well = true;
  for (const auto& robot : targets)
    all_well &= tell(word, robot, before[robot], report_of(session, robot));
  const bool any_silent = whom.team && session.tell_silent(targets);
  return all_well && !(any_silent && word == Word::kHold) ? EXIT_SUCCESS : kFailed;
}

/// Tells whoever listens to stand still before it is known who is there, then as `command`.
int stop(OrderSession& session, Operator& speaker, const Addressees& whom) {
  constexpr Duration kFirstListener = std::chrono::seconds(1);
  if (session.wait(kFirstListener, [&] { return speaker.listeners() > 0; }) &&
      !speaker.say(Word::kHold, {}))
    std::cerr << "galilean-command: DDS did not accept the command, which is sent again\n";
  return command(Word::kHold, session, speaker, whom);
}

int run(Word word, const Addressees& whom, bool at_once = false) try {
  const auto session = OrderSession::join("command", whom.domain);
  if (!session) return fail(session.error().message);
  Operator speaker(session.value()->participant());
  return at_once ? stop(*session.value(), speaker, whom)
                 : command(word, *session.value(), speaker, whom);
} catch (const std::exception& error) {
  return fail(error.what());
}

[[nodiscard]] CommandLine add(CommandLine& app, const char* name, const char* help,
                              Addressees& whom) {
  auto verb = app.command(name, help);
  add_addressees(verb, whom);
  return verb;
}

}  // namespace

int main(int argc, char** argv) {
  Addressees whom;
  CommandLine app("Gives robots an operator's command.", "galilean");
  app.require_command();
  const std::pair<CommandLine, Word> words[] = {
      {add(app, "hold", "Stand still until resumed", whom), Word::kHold},
      {add(app, "resume", "Go on after a hold, or from a break point", whom), Word::kResume},
      {add(app, "start", "Push a bumper, which the start state waits for", whom), Word::kStart},
      {add(app, "decommission", "Stand still until commissioned, whoever resumes", whom),
       Word::kDecommission},
      {add(app, "commission", "Serve again after having been decommissioned", whom),
       Word::kCommission}};
  auto stopping = app.command("stop", "Every robot stands still, at once, until resumed");
  add_domain_option(stopping, whom.domain);
  if (const auto code = app.parse(argc, argv)) return *code;
  if (stopping.chosen()) {
    whom.team = true;
    return run(Word::kHold, whom, true);
  }
  if (const auto named = check_named(whom); !named) return app.refuse(named.error().message);
  for (const auto& [line, word] : words)
    if (line.chosen()) return run(word, whom);
  return kWrongUsage;
}
