// SPDX-License-Identifier: BSD-3-Clause
// galilean-command stop|hold|resume|start|decommission|commission sends an operator's command to
// robots and prints the result.
#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <utility>

#include "core/command_line/command_line.h"
#include "core/command_line/domain_option.h"
#include "core/command_line/exit_code.h"
#include "core/visible_text.h"
#include "monitor/access/operator_key.h"
#include "monitor/orders/command_round.h"

namespace {

using namespace galilean;
using namespace galilean::monitor;
using Word = Operator::Word;

/// Says why what the user typed failed. Returns the exit code.
int fail(const CommandLine& app, const std::string& why) {
  std::cerr << app.typed() << ": " << why << '\n';
  return kFailed;
}

/// Robots take these from anybody, so that a key that is broken is in nobody's way.
bool needs_no_key(Word word) {
  return word == Word::kHold || word == Word::kDecommission;
}

int run(const CommandLine& app, Word word, const Addressees& whom,
        const std::string& key_file) try {
  std::shared_ptr<OrderSigner> signer;
  if (!needs_no_key(word)) {
    auto found = find_signer(key_file);
    if (!found) return fail(app, found.error().message);
    signer = std::move(found).value();
  }
  const auto session = OrderSession::join("command", whom.domain);
  if (!session) return fail(app, session.error().message);
  CommandRound round(*session.value(), word, whom, std::move(signer));
  if (word == Word::kHold && !round.say_at_once())
    std::cerr << app.typed() << ": DDS did not accept the command, which is sent again\n";
  const auto outcomes = round.run();
  if (!outcomes) return fail(app, outcomes.error().message);
  for (const auto& [robot, words, is_well] : outcomes.value())
    std::cout << visible(robot) << ": " << visible(words) << '\n';
  return std::ranges::all_of(outcomes.value(), &CommandOutcome::is_well) ? EXIT_SUCCESS : kFailed;
} catch (const std::exception& error) {
  return fail(app, error.what());
}

[[nodiscard]] CommandLine add(CommandLine& app, const char* name, const char* help,
                              Addressees& whom) {
  auto verb = app.command(name, help);
  add_addressees(verb, whom);
  return verb;
}

[[nodiscard]] CommandLine add_signed(CommandLine& app, const char* name, const char* help,
                                     Addressees& whom, std::string& key_file) {
  auto verb = add(app, name, help, whom);
  add_key_option(verb, key_file);
  return verb;
}

}  // namespace

int main(int argc, char** argv) {
  Addressees whom;
  std::string key_file;
  CommandLine app("Gives robots an operator's command.", "galilean");
  app.require_command();
  const std::pair<CommandLine, Word> words[] = {
      {add(app, "hold", "Stand still until resumed", whom), Word::kHold},
      {add_signed(app, "resume", "Go on after a hold, or from a break point", whom, key_file),
       Word::kResume},
      {add_signed(app, "start", "Push a bumper, which the start state waits for", whom, key_file),
       Word::kStart},
      {add(app, "decommission", "Stand still until commissioned, whoever resumes", whom),
       Word::kDecommission},
      {add_signed(app, "commission", "Serve again after having been decommissioned", whom,
                  key_file),
       Word::kCommission}};
  auto stopping = app.command("stop", "Every robot stands still, at once, until resumed");
  add_domain_option(stopping, whom.domain);
  if (const auto code = app.parse(argc, argv)) return *code;
  if (stopping.chosen()) {
    whom.team = true;
    return run(app, Word::kHold, whom, key_file);
  }
  if (const auto named = check_named(whom); !named) return app.refuse(named.error().message);
  for (const auto& [line, word] : words)
    if (line.chosen()) return run(app, word, whom, key_file);
  return kWrongUsage;
}
