// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/simulation/simulations.h"

#include <gtest/gtest.h>

#include "monitor/simulation/order_options.h"

namespace galilean::monitor {
namespace {

using namespace std::chrono_literals;

msg::SimulationState state_of(const std::string& name) {
  msg::SimulationState state;
  state.simulation = name;
  return state;
}

TEST(Simulations, TheOnlyOneNeedsNoName) {
  Simulations simulations;
  EXPECT_NE(simulations.find("", Time{}).error().message.find("no simulation"), std::string::npos);
  simulations.note(state_of("alpha"), Time{});
  ASSERT_TRUE(simulations.find("", Time{}));
  EXPECT_EQ(simulations.find("", Time{}).value()->simulation, "alpha");
  EXPECT_NE(simulations.find("beta", Time{}).error().message.find("heard is alpha"),
            std::string::npos);
}

TEST(Simulations, OneOfSeveralMustBeNamedAndASilentOneIsGone) {
  Simulations simulations;
  simulations.note(state_of("alpha"), Time{});
  simulations.note(state_of("beta"), Time{} + 2s);
  EXPECT_NE(simulations.find("", Time{} + 2s).error().message.find("alpha, beta"),
            std::string::npos);
  EXPECT_TRUE(simulations.find("alpha", Time{} + 2s));
  EXPECT_EQ(simulations.find("", Time{} + 3s).value()->simulation, "beta");
  EXPECT_FALSE(simulations.find("alpha", Time{} + 3s));
}

std::optional<msg::SimulationOrder> order_of(std::vector<const char*> words) {
  words.insert(words.begin(), "ctl");
  CommandLine app("", "galilean");
  const OrderOptions options(app);
  EXPECT_FALSE(app.parse(static_cast<int>(words.size()), words.data()));
  return options.order();
}

TEST(OrderOptions, ReadWhatEachCommandTakes) {
  EXPECT_EQ(order_of({"go-on"})->order, "go_on");
  EXPECT_EQ(order_of({"step", "0.5"})->duration_s, 0.5);
  const auto moved = order_of({"move", "io", "1", "2", "--heading", "-90"});
  EXPECT_TRUE(moved->turns);
  EXPECT_NEAR(moved->heading_rad, -1.5708, 1e-4);
  EXPECT_FALSE(order_of({"move", "io", "1", "2"})->turns);
  EXPECT_NEAR(order_of({"push", "io", "5", "180"})->heading_rad, 3.1416, 1e-4);
  EXPECT_EQ(order_of({"break", "io", "bumper_1", "--stuck"})->fault, "stuck");
  EXPECT_EQ(order_of({"contest", "reset"})->order, "reset_contest");
  EXPECT_FALSE(order_of({"truth"}));
}

}  // namespace
}  // namespace galilean::monitor
