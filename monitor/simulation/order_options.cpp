// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/simulation/order_options.h"

#include <algorithm>

#include "core/geometry.h"

namespace galilean::monitor {
namespace {

constexpr const char* kContest = "contest";
constexpr const char* kParts =
    "camera, serial_line, board, left_wheel, right_wheel, or bumper_0 (front) to bumper_7, "
    "counter-clockwise";

std::vector<std::string> parts() {
  constexpr int kBumpers = 8;
  std::vector<std::string> names{"camera", "serial_line", "board", "left_wheel", "right_wheel"};
  for (int i = 0; i < kBumpers; ++i) names.push_back("bumper_" + std::to_string(i));
  return names;
}

double radians(double degrees) {
  return degrees * kPi / 180;
}

}  // namespace

OrderOptions::OrderOptions(CommandLine& app) {
  app.require_command();
  add_clock(app);
  add_bodies(app);
  add_parts(app);
  add(app, kContest, "contest", "Start, pause or reset the contest")
      .option("what", contest_,
              "start: begin, or go on after a pause. pause: stop the referee's clock; nothing "
              "counts. reset: put everything back and wait for a start")
      .required()
      .one_of({"start", "pause", "reset"});
  add(app, "", "truth", "Print where everything really is, as JSON");
}

CommandLine& OrderOptions::add(CommandLine& app, const char* order, const char* name,
                               const char* help) {
  return commands_.emplace_back(Command{order, app.command(name, help)}).line;
}

void OrderOptions::add_clock(CommandLine& app) {
  add(app, "pause", "pause", "Stop simulated time; boards and cameras fall silent");
  add(app, "go_on", "go-on", "Let simulated time run again");
  add(app, "step", "step", "Let simulated time run for a while, then pause")
      .option("seconds", read_.duration_s, "How long, in simulated seconds")
      .required()
      .positive();
  add(app, "rate", "rate", "Change how fast simulated time runs")
      .option("factor", read_.rate, "Simulated seconds a second, from 0.1 to 20")
      .required()
      .between(0.1, 20.0);
}

void OrderOptions::add_bodies(CommandLine& app) {
  auto& move = add(app, "move", "move", "Put a robot, a piece, a basket or a chair at a place");
  move.option("name", read_.subject, "Its name, as truth prints it").required();
  move.option("x", read_.x_m, "In metres").required();
  move.option("y", read_.y_m, "In metres").required();
  move.option("--heading", heading_deg_, "Where it heads, in degrees counter-clockwise from x");
  auto& push = add(app, "push", "push", "Push a robot");
  push.option("robot", read_.subject, "Its name").required();
  push.option("impulse", read_.impulse_ns, "How hard, in newton seconds, up to 20")
      .required()
      .positive()
      .between(0.0, 20.0);
  push.option("direction", direction_deg_, "Where to, in degrees counter-clockwise from x")
      .required();
  auto& drop = add(app, "drop", "drop", "Drop a piece");
  drop.option("kind", read_.subject, "can, cup or wad")
      .required()
      .for_example({"can", "cup", "wad"});
  drop.option("x", read_.x_m, "In metres").required();
  drop.option("y", read_.y_m, "In metres").required();
  add(app, "remove", "remove", "Take a piece out of the arena")
      .option("name", read_.subject, "Its name, as truth prints it")
      .required();
}

void OrderOptions::add_parts(CommandLine& app) {
  auto& broken = add(app, "break", "break", "Break a part of a robot");
  broken.option("robot", read_.subject, "Its name").required();
  broken.option("part", read_.part, kParts).required().for_example(parts());
  broken.flag("--stuck", stuck_, "The bumper is pressed for good, and not dead");
  auto& mend = add(app, "mend", "mend", "Mend a part of a robot");
  mend.option("robot", read_.subject, "Its name").required();
  mend.option("part", read_.part, kParts).required().for_example(parts());
}

std::optional<msg::SimulationOrder> OrderOptions::order() const {
  const auto given =
      std::ranges::find_if(commands_, [](const Command& each) { return each.line.chosen(); });
  if (given == commands_.end() || given->order.empty()) return std::nullopt;
  msg::SimulationOrder order = read_;
  order.order = given->order == kContest ? contest_ + "_contest" : given->order;
  order.turns = heading_deg_.has_value();
  order.heading_rad = radians(heading_deg_.value_or(direction_deg_));
  if (stuck_) order.fault = "stuck";
  return order;
}

}  // namespace galilean::monitor
