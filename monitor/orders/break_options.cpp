// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/orders/break_options.h"

#include "monitor/access/operator_key.h"
#include "monitor/orders/break_words.h"

namespace galilean::monitor {
namespace {

namespace kinds = msg::BreakPoint_Constants;

constexpr const char* kPlaces =
    "Where: STATE, on entering it; FROM:TO, at this change of state; FROM:, on leaving FROM";

/// Returns the order, whoever is named.
Result<msg::BreakOrder> order_in(const BreakOptions& options) {
  msg::BreakOrder order;
  order.order = options.clear                  ? "clear"
                : !options.let_through.empty() ? "let_through"
                : options.remove               ? "remove"
                                               : "set";
  if (options.clear) return order;
  auto places = options.places;
  if (!options.let_through.empty()) places = {options.let_through};
  if (places.empty())
    return Error{
        "Name a state, or a change of state as FROM:TO, before --robot and other options."};
  for (const auto& text : places) {
    msg::BreakPoint& point = order.points.emplace_back(place_in(text));
    if (point.from_state.empty() && point.to_state.empty())
      return Error{"'" + text + "' names no state: write STATE, FROM:TO or FROM:"};
    point.kind = options.lock ? kinds::LOCK : options.stop_team ? kinds::STOP_TEAM : kinds::STOP;
  }
  return order;
}

}  // namespace

void add_break_options(CommandLine& line, BreakOptions& options) {
  auto places = line.option("place", options.places, kPlaces);
  add_addressees(line, options.whom);
  add_key_option(line, options.key_file);
  auto stop_team =
      line.flag("--stop-team", options.stop_team, "Stop the whole team, and not this robot alone");
  auto lock =
      line.flag("--lock", options.lock, "Do not make this change of state until it is let through");
  auto remove = line.flag("--remove", options.remove, "Take these break points off");
  auto clear = line.flag("--clear", options.clear, "Take all break points off");
  auto list = line.flag("--list", options.list, "Print where robots stop, and why they stand");
  auto let_through = line.option("--let-through", options.let_through,
                                 "Let this change of state (FROM:TO) through a lock, once");
  lock.excludes(stop_team);
  remove.excludes(stop_team).excludes(lock);
  for (CommandLineOption alone : {clear, list, let_through})
    for (const CommandLineOption& other : {places, stop_team, lock, remove}) alone.excludes(other);
  clear.excludes(list).excludes(let_through);
  list.excludes(let_through);
  line.footer(
      "Orders name their robots with --team or --robot NAME. --list lists every robot that sends "
      "its state, unless --robot names some.");
}

Result<msg::BreakOrder> order_of(const BreakOptions& options) {
  auto order = order_in(options);
  if (const auto named = check_named(options.whom); order && !named) return named.error();
  return order;
}

}  // namespace galilean::monitor
