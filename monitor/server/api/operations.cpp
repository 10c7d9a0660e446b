// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/api/operations.h"

#include <map>

#include "bhdl/diff/diff.h"
#include "core/wire/messages.h"
#include "core/wire/participant.h"
#include "core/wire/ros_time.h"
#include "core/wire/topic_names.h"
#include "monitor/pushes/history/json.h"
#include "monitor/pushes/history/push_messages.h"
#include "monitor/server/text/request_fields.h"

namespace galilean::monitor {
namespace {

namespace kinds = msg::Command_Constants;
const std::map<std::string, std::uint8_t>& command_kinds() {
  static const std::map<std::string, std::uint8_t> kKinds{{"hold", kinds::HOLD},
                                                          {"resume", kinds::RESUME},
                                                          {"push_bumper", kinds::PUSH_BUMPER},
                                                          {"decommission", kinds::DECOMMISSION},
                                                          {"commission", kinds::COMMISSION}};
  return kKinds;
}

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
  const auto found = check_for(files, targets, library).result;
  auto answer = to_json(found);
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
  trial.seeds = static_cast<int>(fields.number("seeds", trial.seeds, 1, 64));
  trial.duration_s = fields.number("duration_s", trial.duration_s, 1, 3600);
  trial.scenario = fields.text("scenario");
  if (!fields.ok()) request.refuse(fields.objection());
  return trial;
}

PushOrder order_of(RequestFields& fields) {
  PushOrder order{.files = files_field(fields),
                  .targets = fields.names("targets"),
                  .author = fields.text("author", "unnamed"),
                  .replaces = fields.text("replaces"),
                  .trial = trial_field(fields),
                  .canary = fields.text("canary")};
  constexpr double kLongest_s = 3600;
  if (fields.find("probation_s"))
    order.probation = from_seconds(fields.number("probation_s", 0, 0, kLongest_s));
  return order;
}

Outcome refused(const RequestFields& fields) {
  return {400, {}, fields.objection()};
}

}  // namespace

Operations::Operations(Worker& worker, const Team& team, const ProgramLibrary& library,
                       PushDesk& desk, wire::Participant& participant)
    : worker_(worker),
      team_(team),
      library_(library),
      desk_(desk),
      commands_(participant, wire::kCommandTopic) {}

void Operations::check(const nlohmann::json& request, Finish finish) {
  RequestFields fields(request);
  auto files = files_field(fields);
  std::vector<bhdl::SourceFile> against;
  if (fields.find("against")) against = files_field(fields, "against");
  const auto name = fields.text("robot");
  if (!fields.ok()) return finish(refused(fields));
  std::vector<Target> targets;
  if (!name.empty()) {
    const Robot* robot = team_.find(name);
    if (!robot) return finish({404, {}, "There is no robot '" + name + "'."});
    targets.push_back(target_of(*robot));
  } else {
    for (const auto& [each, robot] : team_.robots()) targets.push_back(target_of(robot));
  }
  worker_.run([files = std::move(files), targets = std::move(targets), against = std::move(against),
               &library = library_] { return checked(files, targets, against, library); },
              [finish](nlohmann::json json) {
                finish({200, std::move(json)});
              },
              unable(finish));
}

void Operations::push(const nlohmann::json& request, Finish finish) {
  RequestFields fields(request);
  auto order = order_of(fields);
  if (!fields.ok()) return finish(refused(fields));
  desk_.order(std::move(order), [finish = std::move(finish)](const PushAnswer& answer) {
    finish(outcome_of_order(answer));
  });
}

void Operations::cancel_push(const nlohmann::json& request, Finish finish) {
  RequestFields fields(request);
  const auto id = fields.text("id"), author = fields.text("author", "an operator");
  if (!fields.ok()) return finish(refused(fields));
  desk_.cancel(id, author, [finish = std::move(finish)](const PushAnswer& answer) {
    finish(outcome_of(answer));
  });
}

void Operations::command(const nlohmann::json& request, Finish finish) {
  RequestFields fields(request);
  const auto kind = command_kinds().find(fields.text("kind"));
  if (kind == command_kinds().end())
    fields.refuse("'kind' must be hold, resume, push_bumper, decommission or commission.");
  msg::Command command;
  command.id = new_id();
  command.author = fields.text("author", "operator");
  command.targets = fields.names("targets");
  command.argument = fields.whole_number("argument", 0);
  if (!fields.ok()) return finish(refused(fields));
  command.kind = kind->second;
  for (const auto& target : command.targets)
    if (!team_.find(target)) return finish({404, {}, "There is no robot '" + target + "'."});
  send(std::move(command), std::move(finish));
}

void Operations::send(msg::Command command, Finish finish) {
  command.stamp = wire::ros_time(wire::wall_clock_ns());
  worker_.run([this, command] { return commands_.write(command); },
              [finish, id = command.id](bool taken) {
                finish(taken ? Outcome{200, {{"id", id}}}
                             : Outcome{503, {}, "DDS did not accept the command; try again."});
              },
              unable(finish));
}

void Operations::offer(foxglove::Hub& hub) {
  const auto object = [](nlohmann::json properties) {
    return nlohmann::json{{"type", "object"}, {"properties", std::move(properties)}};
  };
  const nlohmann::json text{{"type", "string"}}, number{{"type", "integer"}};
  const nlohmann::json names{{"type", "array"}, {"items", text}};
  const nlohmann::json files{{"type", "array"},
                             {"items", object({{"path", text}, {"text", text}})}};
  const nlohmann::json replies{{"type", "array"}, {"items", {{"type", "object"}}}};

  const auto serve = [](auto operation) {
    return [operation](const nlohmann::json& request, foxglove::Hub::Answer answer) {
      operation(request, [answer = std::move(answer)](const Outcome& outcome) {
        if (outcome.status < 400) return answer(outcome.json);
        answer(Error{outcome.detail});
      });
    };
  };
  hub.add_service({"/galilean/push", "galilean/Push",
                   object({{"files", files},
                           {"targets", names},
                           {"author", text},
                           {"replaces", text},
                           {"try", {{"type", "boolean"}}},
                           {"canary", text},
                           {"probation_s", {{"type", "number"}}}}),
                   object({{"id", text}, {"hash", text}, {"state", text}, {"replies", replies}})},
                  serve([this](const nlohmann::json& request, Finish finish) {
                    push(request, std::move(finish));
                  }));
  hub.add_service(
      {"/galilean/cancel_push", "galilean/CancelPush", object({{"id", text}, {"author", text}}),
       object({{"id", text}, {"state", text}})},
      serve([this](const nlohmann::json& request, Finish finish) {
        cancel_push(request, std::move(finish));
      }));
  for (const auto& [kind, number_of_kind] : command_kinds())
    hub.add_service({"/galilean/" + kind, "galilean/Command",
                     object({{"targets", names}, {"author", text}, {"argument", number}}),
                     object({{"id", text}})},
                    serve([this, kind = kind](nlohmann::json request, Finish finish) {
                      if (request.is_object()) request["kind"] = kind;
                      command(request, std::move(finish));
                    }));
}

}  // namespace galilean::monitor
