// SPDX-License-Identifier: BSD-3-Clause
// galilean-break break|step tells robots where to stop between states, lets them go on to the next
// change of state, and prints what each answers.
#include <algorithm>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <memory>
#include <utility>

#include "core/command_line/exit_code.h"
#include "core/orders/stopping_orders.h"
#include "core/visible_text.h"
#include "monitor/access/operator_key.h"
#include "monitor/orders/break_options.h"
#include "monitor/orders/break_orders.h"
#include "monitor/orders/break_words.h"
#include "monitor/orders/operator.h"

namespace {

using namespace galilean;
using namespace galilean::monitor;

using Names = std::vector<std::string>;

/// Says why what the user typed failed. Returns the exit code.
int fail(const CommandLine& app, const std::string& why) {
  std::cerr << app.typed() << ": " << why << '\n';
  return kFailed;
}

void tell(const std::string& robot, const std::string& what) {
  std::cout << visible(robot) << ": " << visible(what) << '\n';
}

/// Prints what each robot answered to an order of `given`. `effect` says what the order did to a
/// robot that carried it out. Returns the exit code.
int tell_answers(OrderSession& session, const Names& robots, const std::string& order_id,
                 Time given, const std::function<std::string(const std::string& robot)>& effect) {
  const auto unheard = session.wait_for_answers(robots, order_id);
  bool all_did = unheard.empty();
  for (const auto& robot : robots) {
    if (std::ranges::find(unheard, robot) != unheard.end()) {
      tell(robot, session.has_told_since(robot, given) ? "did not answer; try again"
                                                       : session.silence_of(robot));
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

/// Who gives the order, to whom.
struct Giver {
  const Addressees& whom;
  std::shared_ptr<OrderSigner> signer;  ///< null: there is no key
};

Result<int> give(OrderSession& session, msg::BreakOrder order, const Giver& giver,
                 std::size_t there) {
  const Addressees& whom = giver.whom;
  if (const auto may = session.check_leases(whom); !only_stops(order) && !may) return may.error();
  BreakOrders orders(session.participant(), giver.signer);
  order.targets = whom.robots;
  session.wait(OrderSession::kHear, [&] { return orders.listeners() >= static_cast<int>(there); });
  const Time given = session.now();
  const std::string id = orders.give(order);
  if (id.empty()) return Error{"DDS did not accept the order; try again"};
  return tell_answers(session, session.everyone(whom), id, given, [&](const std::string& robot) {
    return with_unknown_states(effect_of(order), order, session.program_of(robot));
  });
}

Result<int> step(OrderSession& session, const Giver& giver, std::size_t there) {
  const Addressees& whom = giver.whom;
  if (const auto may = session.check_leases(whom); !may) return may.error();
  Operator speaker(session.participant(), giver.signer);
  session.wait(OrderSession::kHear, [&] { return speaker.listeners() >= static_cast<int>(there); });
  const Time given = session.now();
  if (!speaker.say(Operator::Word::kStep, whom.robots))
    return Error{"DDS did not accept the command; try again"};
  return tell_answers(
      session, session.everyone(whom), speaker.last_id(), given,
      [](const std::string&) { return std::string("goes on until its next change of state"); });
}

Result<int> list(OrderSession& session, const Addressees& whom) {
  const Time asked = session.now();
  const Names robots = session.everyone(whom);
  const auto told = [&](const std::string& robot) {
    return session.breaks_of(robot) && session.has_told_since(robot, asked);
  };
  const bool all_told =
      session.wait(OrderSession::kAnswer, [&] { return std::ranges::all_of(robots, told); });
  for (const auto& robot : robots) {
    if (!session.has_told_since(robot, asked)) {
      tell(robot, session.silence_of(robot));
      continue;
    }
    const msg::Breaks* breaks = session.breaks_of(robot);
    const Names nothing{"does not tell where it stops"};
    for (const auto& line : breaks ? lines_of(*breaks) : nothing) tell(robot, line);
  }
  return all_told ? EXIT_SUCCESS : kFailed;
}

/// Gives an order to the robots, of which so many are there. Errors: the order cannot be given.
using Talk = std::function<Result<int>(OrderSession& session, std::size_t there)>;

Result<int> run(const Addressees& whom, const Talk& talk) try {
  const auto session = OrderSession::join("break", whom.domain);
  if (!session) return session.error();
  const auto there = session.value()->find(whom);
  if (!there) return there.error();
  return talk(*session.value(), there.value());
} catch (const std::exception& error) {
  return Error{error.what()};
}

Result<int> run_break(const BreakOptions& options, const msg::BreakOrder& order) {
  if (options.list)
    return run(options.whom,
               [&](OrderSession& session, std::size_t) { return list(session, options.whom); });
  auto signer = find_signer(options.key_file);
  if (!signer) return signer.error();
  const Giver giver{options.whom, std::move(signer).value()};
  return run(options.whom, [&](OrderSession& session, std::size_t there) {
    return give(session, order, giver, there);
  });
}

Result<int> run_step(const Addressees& whom, const std::string& key_file) {
  auto signer = find_signer(key_file);
  if (!signer) return signer.error();
  const Giver giver{whom, std::move(signer).value()};
  return run(whom,
             [&](OrderSession& session, std::size_t there) { return step(session, giver, there); });
}

}  // namespace

int main(int argc, char** argv) {
  BreakOptions options;
  Addressees stepping;
  std::string step_key_file;
  CommandLine app("Stops robots between states, and lets them go on step by step.", "galilean");
  app.require_command();
  auto breaking = app.command("break", "Make robots stop, or wait, where their state changes");
  add_break_options(breaking, options);
  auto stepped = app.command("step", "Let robots go on until their next change of state");
  add_addressees(stepped, stepping);
  add_key_option(stepped, step_key_file);
  if (const auto code = app.parse(argc, argv)) return *code;
  const bool breaks = breaking.chosen();
  const auto order = breaks && !options.list ? order_of(options) : msg::BreakOrder{};
  if (!order) return app.refuse(order.error().message);
  if (const auto named = check_named(stepping); !breaks && !named)
    return app.refuse(named.error().message);
  const auto code = breaks ? run_break(options, order.value()) : run_step(stepping, step_key_file);
  return code ? code.value() : fail(app, code.error().message);
}
