// SPDX-License-Identifier: BSD-3-Clause
// galilean-sim-ctl gives a running simulation an instructor's order and prints what became of it.
#include <unistd.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "core/account.h"
#include "core/command_line/domain_option.h"
#include "core/json_text.h"
#include "core/visible_text.h"
#include "core/wire/ros_time.h"
#include "monitor/simulation/order_options.h"
#include "monitor/simulation/simulation_client.h"
#include "monitor/simulation/simulation_json.h"

namespace {

using namespace galilean;
using namespace galilean::monitor;

constexpr Duration kHear = std::chrono::seconds(3);
constexpr Duration kAnswer = std::chrono::seconds(5);

struct Options {
  std::string simulation;
  bool json = false;
  int domain = -1;
};

int fail(const std::string& why) {
  std::cerr << "galilean sim ctl: " << visible(why) << std::endl;
  return 1;
}

void sign(msg::SimulationOrder& order, const std::string& simulation) {
  const std::int64_t now_ns = wire::wall_clock_ns();
  order.stamp = wire::ros_time(now_ns);
  order.id = std::to_string(getpid()) + "-" + std::to_string(now_ns);
  order.author = user_name();
  order.simulation = simulation;
}

int run(const Options& options, std::optional<msg::SimulationOrder> order) try {
  const auto participant = wire::Participant::join("sim-ctl", options.domain);
  if (!participant) return fail(participant.error().message);
  SimulationClient client(*participant.value());
  const auto found = client.find(options.simulation, kHear);
  if (!found) return fail(found.error().message);
  if (!order) return std::cout << json_text(to_json(found.value()), 2) << std::endl, 0;
  sign(*order, found.value().simulation);
  const auto answer = client.send(*order, kAnswer);
  if (!answer) return fail(answer.error().message);
  const auto& event = answer.value();
  if (options.json)
    std::cout << to_json(event) << std::endl;
  else if (event.done)
    std::cout << visible(event.text) << std::endl;
  else
    return fail(event.text);
  return event.done ? 0 : 1;
} catch (const std::exception& error) {
  return fail(error.what());
}

}  // namespace

int main(int argc, char** argv) {
  CommandLine app("Gives a running simulation (galilean demo, galilean sim --live) an order.",
                  "galilean sim ctl");
  Options options;
  app.option("--sim", options.simulation,
             "The simulation, by the name of its run; needed where several run in the domain");
  app.flag("--json", options.json, "Print the answer as one JSON object");
  add_domain_option(app, options.domain);
  app.share_options();
  const OrderOptions orders(app);
  app.footer(
      "Robots in processes of their own keep real time. While the simulation is paused they get no "
      "data: they say so and stand still, but their timers go on. At another rate the world moves "
      "faster or slower under them. Whoever reaches the DDS domain may give orders.");
  if (const auto code = app.parse(argc, argv)) return *code;
  return run(options, orders.order());
}
