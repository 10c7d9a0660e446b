// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/api/operations.h"

#include <algorithm>
#include <cctype>

#include "bhdl/diff/diff.h"
#include "core/device/comm_port.h"
#include "core/orders/stopping_orders.h"
#include "core/wire/messages.h"
#include "core/wire/participant.h"
#include "core/wire/ros_time.h"
#include "core/wire/topic_names.h"
#include "monitor/pushes/history/json.h"
#include "monitor/pushes/history/push_messages.h"
#include "monitor/server/api/break_order.h"
#include "monitor/server/api/command_kinds.h"
#include "monitor/server/api/order_author.h"
#include "monitor/server/text/request_fields.h"

namespace galilean::monitor {
namespace {

std::vector<bhdl::SourceFile> files_field(RequestFields& fields, const char* name = "files") {
  static const nlohmann::json kNone;
  const nlohmann::json* value = fields.find(name);
  auto files = files_from_json(value ? *value : kNone, name);
  if (files) return std::move(files).value();
  fields.refuse(files.error().message + ".");
  return {};
}

/// Returns the diagnostics of `files` as JSON. If both are valid programs, "changes" lists how
/// `files` differs from `against`.
nlohmann::json checked(const std::vector<bhdl::SourceFile>& files,
                       const std::vector<Target>& targets,
                       const std::vector<bhdl::SourceFile>& against,
                       const ProgramLibrary& library) {
  const auto check = check_for(files, targets, library);
  const auto& found = check.result;
  auto answer = to_json(found);
  answer["taken"] = check.taken;
  if (against.empty() || !found.program) return answer;
  const auto runs = check_for(against, targets, library).result;
  if (!runs.program) return answer;
  answer["changes"] = nlohmann::json::array();
  for (const auto& change : bhdl::differences(*runs.program, *found.program, library.catalog()))
    answer["changes"].push_back(bhdl::in_words(change));
  return answer;
}

/// Reads `try`, which is a boolean or {only, even_if_worse, seeds, duration_s, scenario}.
TrialOptions trial_field(RequestFields& request) {
  TrialOptions trial;
  const nlohmann::json* value = request.find("try");
  if (!value) return trial;
  if (value->is_boolean()) {
    trial.wanted = value->get<bool>();
    return trial;
  }
  if (!value->is_object()) return request.refuse("'try' must be true, false or an object."), trial;
  RequestFields fields(*value);
  trial.wanted = true;
  trial.only = fields.flag("only");
  trial.even_if_worse = fields.flag("even_if_worse");
  trial.seeds = fields.whole_number("seeds", trial.seeds, 1, 64);
  trial.duration_s = fields.number("duration_s", trial.duration_s, 1, 3600);
  trial.scenario = fields.text("scenario");
  if (!fields.ok()) request.refuse(fields.objection());
  return trial;
}

/// Returns whether a client may give a push this id. A short one may be another client's, too.
bool is_id(const std::string& text) {
  constexpr std::size_t kShortest = 8, kLongest = 64;
  const auto is_of_id = [](unsigned char letter) {
    return std::isalnum(letter) != 0 || letter == '-' || letter == '_';
  };
  return text.size() >= kShortest && text.size() <= kLongest && std::ranges::all_of(text, is_of_id);
}

PushOrder order_of(RequestFields& fields) {
  PushOrder order{.files = files_field(fields),
                  .targets = fields.names("targets"),
                  .author = fields.text("author"),
                  .replaces = fields.text("replaces"),
                  .trial = trial_field(fields),
                  .canary = fields.text("canary")};
  constexpr double kLongest_s = 3600;
  order.id = fields.text("id");
  if (!order.id.empty() && !is_id(order.id))
    fields.refuse("'id' must be 8 to 64 letters, digits, '-' and '_'.");
  if (fields.find("probation_s"))
    order.probation = from_seconds(fields.number("probation_s", 0, 0, kLongest_s));
  return order;
}

std::int32_t argument_of(std::uint8_t kind, RequestFields& fields) {
  if (kind != msg::Command_Constants::PUSH_BUMPER) return fields.whole_number("argument", 0);
  return fields.whole_number("argument", 0, 0, ControllerStatus::kBumpers - 1);
}

/// Returns what an order does. Whatever is not known to stop robots needs their leases.
template <class M>
OrderKind order_kind(const M& order) {
  return only_stops(order) ? OrderKind::kStops : OrderKind::kSteers;
}

Outcome refused(const RequestFields& fields) {
  return {400, {}, fields.objection()};
}

}  // namespace

Operations::Operations(const Parts& parts, wire::Participant& participant,
                       const std::shared_ptr<OrderSigner>& signer)
    : parts_(parts),
      commands_(participant, wire::kCommandTopic, signer),
      break_orders_(participant, wire::kBreakOrderTopic, signer) {}

void Operations::check(const nlohmann::json& request, Finish finish) {
  RequestFields fields(request);
  auto files = files_field(fields);
  std::vector<bhdl::SourceFile> against;
  if (fields.find("against")) against = files_field(fields, "against");
  const auto name = fields.text("robot");
  if (!fields.ok()) return finish(refused(fields));
  std::vector<Target> targets;
  if (!name.empty()) {
    const Robot* robot = parts_.team.find(name);
    if (!robot) return finish({404, {}, "There is no robot '" + name + "'."});
    targets.push_back(target_of(*robot));
  } else {
    for (const auto& [each, robot] : parts_.team.robots()) targets.push_back(target_of(robot));
  }
  const bool is_taken = parts_.checks.offer(
      [files = std::move(files), targets = std::move(targets), against = std::move(against),
       &library = parts_.library] { return checked(files, targets, against, library); },
      [finish](nlohmann::json json) {
        finish({200, std::move(json)});
      },
      failed(finish));
  if (is_taken) return;
  parts_.limit_counts.reached(Limit::kChecks);
  finish(busy());
}

void Operations::push(const nlohmann::json& request, const OperatorId& who, Finish finish) {
  RequestFields fields(request);
  auto order = order_of(fields);
  order.author = author_of(order.author, who);
  if (!fields.ok()) return finish(refused(fields));
  const bool are_known = std::ranges::all_of(
      order.targets, [this](const std::string& name) { return parts_.team.find(name) != nullptr; });
  // What the desk refuses anyway needs no lease, and neither does a trial. One that comes again
  // gets its first answer, whoever has the lease by now.
  const bool needs_lease = are_known && !order.trial.only;
  const auto admit = [this, who, targets = order.targets, needs_lease, finish] {
    return !needs_lease || admits(OrderKind::kSteers, who, targets, finish);
  };
  parts_.desk.order(
      std::move(order), admit,
      [finish = std::move(finish)](const PushAnswer& answer) { finish(outcome_of_order(answer)); });
}

void Operations::cancel_push(const nlohmann::json& request, const OperatorId& who, Finish finish) {
  RequestFields fields(request);
  const auto id = fields.text("id"), author = author_of(fields.text("author"), who);
  if (!fields.ok()) return finish(refused(fields));
  if (!admits(OrderKind::kStops, who, {}, finish)) return;
  parts_.desk.cancel(id, author, [finish = std::move(finish)](const PushAnswer& answer) {
    finish(outcome_of(answer));
  });
}

void Operations::command(const nlohmann::json& request, const OperatorId& who, Finish finish) {
  RequestFields fields(request);
  const auto kind = command_kinds().find(fields.text("kind"));
  if (kind == command_kinds().end())
    fields.refuse("'kind' must be hold, resume, step, push_bumper, decommission or commission.");
  msg::Command command;
  command.author = author_of(fields.text("author"), who);
  command.targets = fields.names("targets");
  command.argument = argument_of(kind == command_kinds().end() ? 0 : kind->second, fields);
  if (!fields.ok()) return finish(refused(fields));
  command.kind = kind->second;
  const OrderKind does = order_kind(command);
  send(commands_, std::move(command), does, who, std::move(finish));
}

void Operations::order_breaks(const nlohmann::json& request, const OperatorId& who, Finish finish) {
  RequestFields fields(request);
  auto order = break_order(fields);
  order.author = author_of(order.author, who);
  if (!fields.ok()) return finish(refused(fields));
  const OrderKind does = order_kind(order);
  send(break_orders_, std::move(order), does, who, std::move(finish));
}

template <class M>
void Operations::send(SignedWriter<M>& writer, M message, OrderKind kind, const OperatorId& who,
                      Finish finish) {
  for (const auto& target : message.targets)
    if (!parts_.team.find(target)) return finish({404, {}, "There is no robot '" + target + "'."});
  message.id = new_id();
  message.stamp = wire::ros_time(wire::wall_clock_ns());
  const auto refuse = [this, &message, &finish](Outcome refusal) {
    const auto robots = message.targets.empty() ? team_now() : message.targets;
    parts_.orders.note_refused(message, robots, refusal.detail);
    finish(std::move(refusal));
  };
  if (!admits(kind, who, message.targets, refuse)) return;
  parts_.orders.expect(message.id);
  const bool is_taken = parts_.commands.offer(
      [&writer, message] { return writer.write(message); },
      [this, message, finish](bool taken) {
        if (!taken) return finish({503, {}, "DDS did not accept the order; try again."});
        keep(message, finish);
      },
      failed(finish));
  if (is_taken) return;
  parts_.limit_counts.reached(Limit::kCommands);
  finish(busy());
}

template <class M>
void Operations::keep(const M& message, const Finish& finish) {
  parts_.orders.note(message, [finish, id = message.id](const Result<void>& kept) {
    nlohmann::json answer{{"id", id}};
    if (!kept) answer["not_kept"] = kept.error().message;
    finish({200, std::move(answer)});
  });
}

}  // namespace galilean::monitor
