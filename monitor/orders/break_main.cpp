// SPDX-License-Identifier: BSD-3-Clause
// galilean-break break|step tells robots where to stop between states, lets them go on to the next
// change of state, and prints what each answers.
#include <algorithm>
#include <cstdlib>
#include <functional>
#include <iostream>

#include "core/command_line/exit_code.h"
#include "core/visible_text.h"
#include "monitor/orders/break_options.h"
#include "monitor/orders/break_orders.h"
#include "monitor/orders/break_words.h"
#include "monitor/orders/operator.h"

namespace {

using namespace galilean;
using namespace galilean::monitor;

using Names = std::vector<std::string>;

int fail(const std::string& why) {
  std::cerr << "galilean-break: " << why << '\n';
  return kFailed;
}

void tell(const std::string& robot, const std::string& what) {
  std::cout << visible(robot) << ": " << visible(what) << '\n';
}

/// Prints what each robot answered. `effect` says what the order did to a robot that carried it
/// out. Returns the exit code.
int tell_answers(OrderSession& session, const Names& robots, const std::string& order_id,
                 const std::function<std::string(const std::string& robot)>& effect) {
  const auto unheard = session.wait_for_answers(robots, order_id);
  bool all_did = unheard.empty();
  for (const auto& robot : robots) {
    if (std::ranges::find(unheard, robot) != unheard.end()) {
      tell(robot, "did not answer; try again");
      continue;
    }
    const std::string& refused = session.answer_of(robot, order_id)->refused;
    tell(robot, refused.empty() ? effect(robot) : "refused: " + refused);
    all_did &= refused.empty();
  }
  return all_did ? EXIT_SUCCESS : kFailed;
}

/// Appends which of the order's states the robot's program does not have.
std::string with_unknown_states(std::string effect, const msg::BreakOrder& order,
                                const msg::Program* program) {
  if (!program || order.order != "set") return effect;
  for (const auto& state : unknown_states(order, *program))
    effect += "; its program has no state '" + state + "'";
  return effect;
}

int give(OrderSession& session, msg::BreakOrder order, const Addressees& whom,
         const Names& robots) {
  BreakOrders orders(session.participant());
  order.targets = whom.robots;
  session.wait(OrderSession::kHear,
               [&] { return orders.listeners() >= static_cast<int>(robots.size()); });
  const std::string id = orders.give(order);
  if (id.empty()) return fail("DDS did not accept the order; try again");
  return tell_answers(session, robots, id, [&](const std::string& robot) {
    return with_unknown_states(effect_of(order), order, session.program_of(robot));
  });
}

int step(OrderSession& session, const Addressees& whom, const Names& robots) {
  Operator speaker(session.participant());
  session.wait(OrderSession::kHear,
               [&] { return speaker.listeners() >= static_cast<int>(robots.size()); });
  if (!speaker.say(Operator::Word::kStep, whom.robots))
    return fail("DDS did not accept the command; try again");
  return tell_answers(session, robots, speaker.last_id(), [](const std::string&) {
    return std::string("goes on until its next change of state");
  });
}

int list(OrderSession& session, const Names& robots) {
  const auto told = [&](const std::string& robot) { return session.breaks_of(robot) != nullptr; };
  const bool all_told =
      session.wait(OrderSession::kAnswer, [&] { return std::ranges::all_of(robots, told); });
  for (const auto& robot : robots) {
    const msg::Breaks* breaks = session.breaks_of(robot);
    const Names nothing{"does not tell where it stops"};
    for (const auto& line : breaks ? lines_of(*breaks) : nothing) tell(robot, line);
  }
  return all_told ? EXIT_SUCCESS : kFailed;
}

using Talk = std::function<int(OrderSession& session, const Names& robots)>;

int run(const Addressees& whom, const Talk& talk) try {
  const auto session = OrderSession::join("break", whom.domain);
  if (!session) return fail(session.error().message);
  const auto robots = session.value()->find(whom);
  if (!robots) return fail(robots.error().message);
  return talk(*session.value(), robots.value());
} catch (const std::exception& error) {
  return fail(error.what());
}

int run_break(const BreakOptions& options, const CommandLine& app) {
  if (options.list) return run(options.whom, list);
  const auto order = order_of(options);
  if (!order) return app.refuse(order.error().message);
  return run(options.whom, [&](OrderSession& session, const Names& robots) {
    return give(session, order.value(), options.whom, robots);
  });
}

}  // namespace

int main(int argc, char** argv) {
  BreakOptions options;
  Addressees stepping;
  CommandLine app("Stops robots between states, and lets them go on step by step.", "galilean");
  app.require_command();
  auto breaking = app.command("break", "Make robots stop, or wait, where their state changes");
  add_break_options(breaking, options);
  auto stepped = app.command("step", "Let robots go on until their next change of state");
  add_addressees(stepped, stepping);
  if (const auto code = app.parse(argc, argv)) return *code;
  if (breaking.chosen()) return run_break(options, app);
  if (const auto named = check_named(stepping); !named) return app.refuse(named.error().message);
  return run(stepping, [&](OrderSession& session, const Names& robots) {
    return step(session, stepping, robots);
  });
}
