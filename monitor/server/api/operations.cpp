#include "monitor/server/api/operations.h"

#include <map>

#include "bhdl/diff/diff.h"
#include "core/wire/messages.h"
#include "core/wire/participant.h"
#include "core/wire/ros_time.h"
#include "core/wire/topic_names.h"
#include "monitor/pushes/json.h"
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

std::vector<bhdl::SourceFile> files_field(const nlohmann::json& request,
                                          const char* name = "files") {
  auto files = files_from_json(request.value(name, nlohmann::json()));
  if (!files) throw BadRequest(files.error().message + ".");
  return std::move(files).value();
}

/// What was found; and, where both are programs, what `files` tells a robot otherwise than
/// `against`.
nlohmann::json checked(const std::vector<bhdl::SourceFile>& files,
                       const std::vector<Target>& targets,
                       const std::vector<bhdl::SourceFile>& against,
                       const ProgramLibrary& library) {
  const auto found = check_for(files, targets, library).result;
  auto json = to_json(found);
  if (against.empty() || !found.program) return json;
  const auto runs = check_for(against, targets, library).result;
  if (!runs.program) return json;
  json["changes"] = nlohmann::json::array();
  for (const auto& change : bhdl::differences(*runs.program, *found.program, library.catalog()))
    json["changes"].push_back(bhdl::in_words(change));
  return json;
}

/// `try` is true, or {only, even_if_worse, seeds, duration_s, scenario}.
void read_trial(const nlohmann::json& request, PushOrder& order) {
  if (!request.contains("try")) return;
  const auto& trial = request["try"];
  if (!trial.is_boolean() && !trial.is_object())
    throw BadRequest("'try' must be true, false or an object.");
  order.trial.wanted = trial.is_object() || trial.get<bool>();
  if (!trial.is_object()) return;
  order.trial.only = flag_field(trial, "only");
  order.trial.even_if_worse = flag_field(trial, "even_if_worse");
  order.trial.seeds = static_cast<int>(number_field(trial, "seeds", order.trial.seeds, 1, 64));
  order.trial.duration_s = number_field(trial, "duration_s", order.trial.duration_s, 1, 3600);
  order.trial.scenario = text_field(trial, "scenario");
}

PushOrder order_of(const nlohmann::json& request) {
  PushOrder order{.files = files_field(request),
                  .targets = names_field(request, "targets"),
                  .author = text_field(request, "author", "unnamed"),
                  .replaces = text_field(request, "replaces")};
  read_trial(request, order);
  order.canary = text_field(request, "canary");
  constexpr double kLongest_s = 3600;
  if (request.contains("probation_s"))
    order.probation = from_seconds(number_field(request, "probation_s", 0, 0, kLongest_s));
  return order;
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
  auto files = files_field(request);
  std::vector<bhdl::SourceFile> against;
  if (request.contains("against")) against = files_field(request, "against");
  std::vector<Target> targets;
  if (const auto name = text_field(request, "robot"); !name.empty()) {
    const Robot* robot = team_.find(name);
    if (!robot) return finish({404, {}, "There is no robot '" + name + "'."});
    targets.push_back(target_of(*robot));
  } else {
    for (const auto& [each, robot] : team_.robots()) targets.push_back(target_of(robot));
  }
  worker_.run([files = std::move(files), targets = std::move(targets), against = std::move(against),
               &library = library_] { return checked(files, targets, against, library); },
              [finish = std::move(finish)](nlohmann::json json) {
                finish({200, std::move(json)});
              });
}

void Operations::push(const nlohmann::json& request, Finish finish) {
  desk_.order(order_of(request), std::move(finish));
}

void Operations::cancel_push(const nlohmann::json& request, Finish finish) {
  desk_.cancel(text_field(request, "id"), text_field(request, "author", "an operator"),
               std::move(finish));
}

void Operations::command(const nlohmann::json& request, Finish finish) {
  const auto kind = command_kinds().find(text_field(request, "kind"));
  if (kind == command_kinds().end())
    throw BadRequest("'kind' must be hold, resume, push_bumper, decommission or commission.");
  msg::Command command;
  command.id = new_id();
  command.author = text_field(request, "author", "operator");
  command.targets = names_field(request, "targets");
  command.kind = kind->second;
  command.argument = whole_number_field(request, "argument", 0);
  for (const auto& target : command.targets)
    if (!team_.find(target)) return finish({404, {}, "There is no robot '" + target + "'."});
  send(std::move(command), std::move(finish));
}

void Operations::send(msg::Command command, Finish finish) {
  command.stamp = wire::ros_time(wire::wall_clock_ns());
  worker_.run([this, command] { return commands_.write(command); },
              [finish = std::move(finish), id = command.id](bool taken) {
                finish(taken ? Outcome{200, {{"id", id}}}
                             : Outcome{503, {}, "DDS did not take the command; try again."});
              });
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
      try {
        operation(request, [answer](const Outcome& outcome) {
          if (outcome.status < 400) return answer(outcome.json);
          answer(Error{outcome.detail});
        });
      } catch (const BadRequest& wrong) {
        answer(Error{wrong.what()});
      }
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
                      if (!request.is_object()) throw BadRequest("A call must be a JSON object.");
                      request["kind"] = kind;
                      command(request, std::move(finish));
                    }));
}

}  // namespace galilean::monitor
