// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/simulation/simulation_json.h"

#include <nlohmann/json.hpp>

namespace galilean::monitor {

nlohmann::json to_json(const msg::SimulationState& state) {
  auto bodies = nlohmann::json::array();
  for (const auto& body : state.bodies)
    bodies.push_back({{"name", body.name},
                      {"kind", body.kind},
                      {"x_m", body.x_m},
                      {"y_m", body.y_m},
                      {"heading_rad", body.heading_rad},
                      {"held_by", body.held_by}});
  auto faults = nlohmann::json::array();
  for (const auto& fault : state.faults)
    faults.push_back({{"robot", fault.robot}, {"part", fault.part}, {"fault", fault.fault}});
  return {
      {"simulation", state.simulation},   {"scenario", state.scenario}, {"step", state.step},
      {"simulated_s", state.simulated_s}, {"paused", state.paused},     {"rate", state.rate},
      {"contest", state.contest},         {"width_m", state.width_m},   {"depth_m", state.depth_m},
      {"bodies", std::move(bodies)},      {"faults", std::move(faults)}};
}

nlohmann::json to_json(const msg::SimulationEvent& event) {
  return {{"simulation", event.simulation},
          {"number", event.number},
          {"order_id", event.order_id},
          {"author", event.author},
          {"order", event.order},
          {"subject", event.subject},
          {"done", event.done},
          {"text", event.text},
          {"step", event.step},
          {"simulated_s", event.simulated_s}};
}

}  // namespace galilean::monitor
