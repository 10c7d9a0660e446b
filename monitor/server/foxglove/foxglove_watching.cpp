// SPDX-License-Identifier: BSD-3-Clause
// A client's subscriptions to parameters and to the connection graph.
#include "monitor/access/access.h"
#include "monitor/server/foxglove/foxglove_hub.h"
#include "monitor/server/text/request_fields.h"

namespace galilean::monitor::foxglove {
namespace {

/// Returns those of `all` that `names` lists; an empty list means all.
ParameterValues named(const ParameterValues& all, const std::vector<std::string>& names) {
  if (names.empty()) return all;
  ParameterValues some;
  for (const auto& name : names)
    if (const auto found = all.find(name); found != all.end()) some.insert(*found);
  return some;
}

}  // namespace

void Hub::Client::get_parameters(RequestFields& request) {
  const auto names = request.names("parameterNames");
  const auto id = request.text("id");
  if (request.ok()) tell(parameter_values(named(hub_.parameters_, names), id));
}

void Hub::Client::set_parameters(RequestFields& request) {
  const auto id = request.text("id");
  const auto& parameters = request.list("parameters");
  if (!request.ok()) return;
  std::vector<std::string> names;
  for (const auto& item : parameters) {
    if (!item.is_object() || !item.contains("name") || !item["name"].is_string()) {
      refuse("A parameter must have a string \"name\".");
      continue;
    }
    names.push_back(item["name"]);
    set_parameter({item["name"], item.value("value", nlohmann::json())});
  }
  if (!id.empty() && !names.empty()) tell(parameter_values(named(hub_.parameters_, names), id));
}

void Hub::Client::set_parameter(const Parameter& wanted) {
  if (!may_call_) return refuse(missing_right(Right::kOperate));
  if (!hub_.parameters_.contains(wanted.name) || !hub_.set_parameter_)
    return refuse("There is no parameter \"" + wanted.name + "\".");
  hub_.caller_ = who_;
  hub_.set_parameter_(wanted, [this, alive = alive_](const Result<nlohmann::json>& result) {
    if (*alive && !result) refuse(result.error().message);
  });
}

void Hub::Client::watch_parameters(RequestFields& request, bool wanted) {
  const auto names = request.names("parameterNames");
  if (!request.ok()) return;
  for (const auto& [name, value] : named(hub_.parameters_, names))
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
