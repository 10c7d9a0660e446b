// SPDX-License-Identifier: BSD-3-Clause
#include <optional>
#include <string>
#include <vector>

#include "monitor/server/api/api.h"
#include "monitor/server/api/order_author.h"
#include "monitor/server/text/request_fields.h"
#include "monitor/simulation/simulation_json.h"

namespace galilean::monitor {
namespace {

/// Returns the order that a request asks for. Only types are checked here: what an order means, and
/// which values are possible, only the simulation knows.
msg::SimulationOrder simulation_order(RequestFields& fields) {
  constexpr double kMost = 1e6;
  const auto number = [&](const char* name) { return fields.number(name, 0, -kMost, kMost); };
  msg::SimulationOrder order;
  order.author = fields.text("author");
  order.simulation = fields.text("simulation");
  order.subject = fields.text("subject");
  order.part = fields.text("part");
  order.fault = fields.text("fault");
  order.x_m = number("x_m");
  order.y_m = number("y_m");
  order.turns = fields.find("heading_rad") != nullptr;
  order.heading_rad = number("heading_rad");
  order.impulse_ns = number("impulse_ns");
  order.duration_s = number("duration_s");
  order.rate = number("rate");
  order.order = fields.text("order");
  if (order.order.empty()) fields.refuse("'order' must say what to do, such as pause.");
  return order;
}

/// Returns the robots whose leases the order needs: the one to which something is done, or none by
/// name, which is the team, where the contest's start pushes everybody's bumper. Pieces, furniture
/// and the clock have no leases.
std::optional<std::vector<std::string>> steered_by(const msg::SimulationOrder& order,
                                                   const Team& team) {
  if (order.order == "start_contest") return std::vector<std::string>();
  if (team.find(order.subject)) return std::vector<std::string>{order.subject};
  return std::nullopt;
}

int status_of(UnansweredOrder::Reason reason) {
  switch (reason) {
    case UnansweredOrder::Reason::kNoSimulation:
      return 404;
    case UnansweredOrder::Reason::kSilent:
    case UnansweredOrder::Reason::kUnable:
      return 503;
  }
  return 500;
}

Outcome outcome_of(const SimulationDesk::Answer& answer) {
  if (!answer) {
    const auto& [reason, message] = answer.error();
    return {status_of(reason), {}, "The order has no answer: " + message + "."};
  }
  const auto& event = answer.value();
  if (!event.done) return {409, {{"event", to_json(event)}}, event.text + "."};
  return {200, to_json(event)};
}

}  // namespace

void Api::add_simulation_routes() {
  post("/api/simulation/orders", Right::kOperate, parts_.limits.command,
       [this](auto& request, auto& body, auto& respond) {
         RequestFields fields(body);
         auto order = simulation_order(fields);
         order.author = author_of(order.author, request.who);
         if (!fields.ok()) return respond(problem(400, fields.objection()));
         if (const auto robots = steered_by(order, parts_.team);
             robots && !parts_.operations.admits(OrderKind::kSteers, request.who, *robots,
                                                 finish_of(respond)))
           return;
         parts_.simulations.order(
             std::move(order),
             [finish = finish_of(respond)](const auto& answer) { finish(outcome_of(answer)); });
       });
}

}  // namespace galilean::monitor
