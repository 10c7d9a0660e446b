// SPDX-License-Identifier: BSD-3-Clause
// The operations as Foxglove services.
#include "monitor/server/api/command_kinds.h"
#include "monitor/server/api/operations.h"

namespace galilean::monitor {

void Operations::offer(foxglove::Hub& hub) {
  const auto object = [](nlohmann::json properties) {
    return nlohmann::json{{"type", "object"}, {"properties", std::move(properties)}};
  };
  const nlohmann::json text{{"type", "string"}}, number{{"type", "integer"}};
  const nlohmann::json names{{"type", "array"}, {"items", text}};
  const nlohmann::json files{{"type", "array"},
                             {"items", object({{"path", text}, {"text", text}})}};
  const nlohmann::json replies{{"type", "array"}, {"items", {{"type", "object"}}}};
  const nlohmann::json points{{"type", "array"},
                              {"items", object({{"from", text}, {"to", text}, {"kind", text}})}};

  const auto serve = [&hub](auto operation) {
    return [operation, &hub](const nlohmann::json& request, foxglove::Hub::Answer answer) {
      operation(request, hub.caller(), [answer = std::move(answer)](const Outcome& outcome) {
        if (outcome.status < 400) return answer(outcome.json);
        answer(Error{outcome.detail});
      });
    };
  };
  hub.add_service({"/galilean/push", "galilean/Push",
                   object({{"files", files},
                           {"targets", names},
                           {"author", text},
                           {"id", text},
                           {"replaces", text},
                           {"try", {{"type", "boolean"}}},
                           {"canary", text},
                           {"probation_s", {{"type", "number"}}}}),
                   object({{"id", text}, {"hash", text}, {"state", text}, {"replies", replies}})},
                  serve([this](const nlohmann::json& request, const OperatorId& who,
                               Finish finish) { push(request, who, std::move(finish)); }));
  hub.add_service(
      {"/galilean/cancel_push", "galilean/CancelPush", object({{"id", text}, {"author", text}}),
       object({{"id", text}, {"state", text}})},
      serve([this](const nlohmann::json& request, const OperatorId& who, Finish finish) {
        cancel_push(request, who, std::move(finish));
      }));
  for (const auto& [kind, number_of_kind] : command_kinds())
    hub.add_service(
        {"/galilean/" + kind, "galilean/Command",
         object({{"targets", names}, {"author", text}, {"argument", number}}),
         object({{"id", text}})},
        serve([this, kind = kind](nlohmann::json request, const OperatorId& who, Finish finish) {
          if (request.is_object()) request["kind"] = kind;
          command(request, who, std::move(finish));
        }));
  hub.add_service(
      {"/galilean/breaks", "galilean/Breaks",
       object({{"targets", names}, {"author", text}, {"order", text}, {"points", points}}),
       object({{"id", text}})},
      serve([this](const nlohmann::json& request, const OperatorId& who, Finish finish) {
        order_breaks(request, who, std::move(finish));
      }));
  hub.add_service({"/galilean/lease", "galilean/Lease",
                   object({{"do", text}, {"robots", names}, {"reason", text}}),
                   object({{"leases", {{"type", "object"}}}})},
                  serve([this](const nlohmann::json& request, const OperatorId& who,
                               Finish finish) { change_lease(request, who, std::move(finish)); }));
}

}  // namespace galilean::monitor
