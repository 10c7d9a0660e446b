// What a client watches besides channels: parameters and the connection graph.
#include "monitor/access/access.h"
#include "monitor/server/foxglove/foxglove_hub.h"
#include "monitor/server/foxglove/foxglove_request.h"

namespace galilean::monitor::foxglove {
namespace {

/// Those of `all` that `names` lists; an empty list means all.
ParameterValues named(const ParameterValues& all, const nlohmann::json& names) {
  if (names.empty()) return all;
  ParameterValues some;
  for (const auto& name : names)
    if (name.is_string())
      if (const auto found = all.find(name); found != all.end()) some.insert(*found);
  return some;
}

std::string id_text(const nlohmann::json& request) {
  if (!request.contains("id") || !request["id"].is_string()) return {};
  return request["id"];
}

}  // namespace

void Hub::Client::get_parameters(const nlohmann::json& request) {
  tell(parameter_values(named(hub_.parameters_, list_of(request, "parameterNames")),
                        id_text(request)));
}

void Hub::Client::set_parameters(const nlohmann::json& request) {
  auto names = nlohmann::json::array();
  for (const auto& item : list_of(request, "parameters")) {
    if (!item.is_object() || !item.contains("name") || !item["name"].is_string()) {
      refuse("A parameter must have a string \"name\".");
      continue;
    }
    names.push_back(item["name"]);
    set_parameter({item["name"], item.value("value", nlohmann::json())});
  }
  const auto id = id_text(request);
  if (!id.empty() && !names.empty()) tell(parameter_values(named(hub_.parameters_, names), id));
}

void Hub::Client::set_parameter(const Parameter& wanted) {
  if (!may_call_) return refuse(missing_right(Right::kOperate));
  if (!hub_.parameters_.contains(wanted.name) || !hub_.set_parameter_)
    return refuse("There is no parameter \"" + wanted.name + "\".");
  hub_.set_parameter_(wanted, [this, alive = alive_](const Result<nlohmann::json>& result) {
    if (*alive && !result) refuse(result.error().message);
  });
}

void Hub::Client::watch_parameters(const nlohmann::json& request, bool wanted) {
  for (const auto& [name, value] : named(hub_.parameters_, list_of(request, "parameterNames")))
    if (wanted)
      watched_parameters_.insert(name);
    else
      watched_parameters_.erase(name);
}

void Hub::Client::tell_parameters(const ParameterValues& changed) {
  ParameterValues watched;
  for (const auto& each : changed)
    if (watched_parameters_.contains(each.first)) watched.insert(each);
  if (!watched.empty()) tell(parameter_values(watched, {}));
}

void Hub::Client::watch_graph(bool wanted) {
  if (wanted && !watches_graph_) tell(graph_update({}, hub_.graph_));
  watches_graph_ = wanted;
}

}  // namespace galilean::monitor::foxglove
